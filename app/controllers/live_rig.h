#pragma once

#include "app/controllers/live_window.h"
#include "app/devices/live_devices.h"
#include "calib/rig.h"
#include "engine/base/result.h"

#include <optional>
#include <string>

namespace tractus::controllers {

// What a window that is drawn in makes of its devices: which of them the mouse stands in for, and
// what they mean in millimetres.

bool has_height_sensor(devices::LiveDevices const& devices);

// Devices that the mouse stands in for.
struct MouseParts {
    bool pen = false;
    bool height = false;
};

// Adds the mouse, if the options have one, for what the devices lack.
MouseParts add_mouse(devices::LiveDevices& devices, LiveWindowOptions const& options);

// The rig's height sensor has never been calibrated: its readings mean nothing yet.
bool lacks_calibration(devices::LiveDevices const& devices, LiveWindowOptions const& options);

// The rig of the options, else of a log among the devices, else one of the first tablet's size;
// with the mouse's height sensor where it stands in for that. Fails, as the user's fault, for a rig
// that cannot be read, and where there is a height sensor whose calibration could not be kept.
Result<calib::Rig> choose_rig(devices::LiveDevices const& devices, LiveWindowOptions const& options,
                              MouseParts const& mouse);

// Says what to do about a tablet whose sides nobody knows: drawings may be squashed.
std::optional<std::string> size_note(devices::LiveDevices const& devices, calib::Rig const& rig);

} // namespace tractus::controllers
