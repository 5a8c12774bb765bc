#pragma once

#include "engine/base/vectors.h"

#include <filesystem>
#include <optional>

namespace tractus::drivers {

// A tablet's active width and height in whole millimetres, as the kernel's driver reports them
// through udev (ID_INPUT_WIDTH_MM and ID_INPUT_HEIGHT_MM of the pen's input device). Drivers such
// as wacom and uclogic know sizes that report descriptors lack. No value if the device is not a
// tablet, if its driver does not know the size, or without udev. `hidraw_folder` is the node's
// folder in sysfs, such as "/sys/class/hidraw/hidraw3".
std::optional<Vec2> size_known_to_udev(std::filesystem::path const& hidraw_folder);

} // namespace tractus::drivers
