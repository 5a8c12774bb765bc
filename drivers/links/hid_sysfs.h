#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace tractus::drivers {

// The USB device and interface of a HID device.
struct UsbParent {
    std::string address {};    // Name of the device in /sys/bus/usb/devices, such as "1-2.3".
    int interface_number = -1; // Number of the interface; -1 if it is not known.
    std::string manufacturer {};
    std::string product {};
    std::string serial_number {};
};

// Looks up the USB parent of a hidraw node, given its sysfs folder ("/sys/class/hidraw/hidraw3").
// No value if the device is not on USB or has gone away.
std::optional<UsbParent> find_usb_parent(std::filesystem::path const& hidraw_folder);

// The kernel's driver for the node: "hid-generic", "wacom", "uclogic"; empty if there is none.
std::string bound_driver(std::filesystem::path const& hidraw_folder);

} // namespace tractus::drivers
