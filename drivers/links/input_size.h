#pragma once

#include "engine/base/vectors.h"

#include <filesystem>
#include <optional>

namespace tractus::drivers {

// A tablet's active area in millimetres, X then Y, as the kernel's driver for it knows it and udev
// tells (ID_INPUT_WIDTH_MM and ID_INPUT_HEIGHT_MM of the pen's input device), to whole millimetres.
// Drivers such as wacom and uclogic know sizes that descriptors do not tell. No value for a device
// that is no tablet, whose driver does not know, or where no udev runs. `hidraw_folder` is the
// node's in sysfs, "/sys/class/hidraw/hidraw3".
std::optional<Vec2> size_known_to_udev(std::filesystem::path const& hidraw_folder);

} // namespace tractus::drivers
