#pragma once

#include "app/controllers/live_window.h"
#include "app/devices/live_devices.h"
#include "calib/rig.h"
#include "engine/base/result.h"

#include <optional>
#include <string>

namespace tractus::controllers {

// Helpers for live drawing: which devices the mouse replaces, and the rig, which converts reports
// to millimetres.

bool has_height_sensor(devices::LiveDevices const& devices);

// Devices that the mouse replaces.
struct MouseParts {
    bool pen = false;
    bool height = false;
};

// Adds the mouse, if the options include one, for missing devices.
MouseParts add_mouse(devices::LiveDevices& devices, LiveWindowOptions const& options);

// True if the rig's height sensor was never calibrated, so that its readings have no meaning yet.
bool lacks_calibration(devices::LiveDevices const& devices, LiveWindowOptions const& options);

// Returns the rig of the options; otherwise that of a log among the devices; otherwise a default
// rig with the first tablet's size. Includes the mouse's height sensor if it is used. Fails with a
// user error if a rig cannot be read, or if a height sensor is uncalibrated and its calibration
// could not be saved.
Result<calib::Rig> choose_rig(devices::LiveDevices const& devices, LiveWindowOptions const& options,
                              MouseParts const& mouse);

// A message for a tablet of unknown size, whose drawings may be distorted, with the remedy.
std::optional<std::string> size_note(devices::LiveDevices const& devices, calib::Rig const& rig);

} // namespace tractus::controllers
