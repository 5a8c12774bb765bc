#pragma once

#include "app/controllers/live_window.h"
#include "app/devices/live_devices.h"
#include "calib/rig.h"
#include "engine/base/result.h"

#include <optional>
#include <string>

namespace tractus::controllers {

// Helpers for live drawing. They choose the devices that the mouse replaces, and the rig, by which
// reports are converted to millimetres.

bool has_height_sensor(devices::LiveDevices const& devices);

// The devices that the mouse replaces.
struct MouseParts {
    bool pen = false;
    bool height = false;
};

// If the options include a mouse, adds it in place of missing devices. Returns what it replaces.
MouseParts add_mouse(devices::LiveDevices& devices, LiveWindowOptions const& options);

// True if there is a height sensor but no calibration for it, so that its readings have no meaning
// yet.
bool lacks_calibration(devices::LiveDevices const& devices, LiveWindowOptions const& options);

// Returns the rig of the options; if there is none, the rig of a log among the devices; otherwise a
// default rig with the first tablet's size. The mouse's height sensor is added if it is used. Fails
// with a user error if a rig cannot be read, or if a height sensor is uncalibrated and a
// calibration could not be saved.
Result<calib::Rig> choose_rig(devices::LiveDevices const& devices, LiveWindowOptions const& options,
                              MouseParts const& mouse);

// Returns a message, with the remedy, if the tablet's size is unknown, as drawings may then be
// distorted.
std::optional<std::string> size_note(devices::LiveDevices const& devices, calib::Rig const& rig);

} // namespace tractus::controllers
