#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace tractus::drivers {

// Where a HID device hangs on USB.
struct UsbParent {
    std::string address {};    // Name in /sys/bus/usb/devices: "1-2.3".
    int interface_number = -1; // -1 if it is not known.
    std::string manufacturer {};
    std::string product {};
    std::string serial_number {};
};

// Returns what sysfs tells of a hidraw node's folder ("/sys/class/hidraw/hidraw3"). No value for a
// device that is not on USB, or that went away.
std::optional<UsbParent> find_usb_parent(std::filesystem::path const& hidraw_folder);

// The kernel's driver for the node: "hid-generic", "wacom", "uclogic"; empty if there is none.
std::string bound_driver(std::filesystem::path const& hidraw_folder);

} // namespace tractus::drivers
