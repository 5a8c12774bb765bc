#pragma once

#include "drivers/reports/device_info.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::drivers {

// One interface of a USB device that is plugged in.
struct UsbInterface {
    std::filesystem::path folder {}; // Folder in sysfs: ".../1-2.3:1.0".
    std::string port {};             // "1-2.3"

    // USB 2.0 section 9.6.5: what it is for. Class 3 is HID, 255 its maker's own.
    int usb_class = 0;
    int subclass = 0;
    int protocol = 0;

    // Names, ids, the interface's number and its place; the location is for whoever reads it.
    DeviceInfo info {};

    // The device's folder, with what it says of itself.
    std::filesystem::path device_folder() const { return folder.parent_path() / port; }
};

// Every interface of every USB device, in the order of their ports and numbers. Reads sysfs alone,
// for which no permission is needed: what cannot be read is left empty.
std::vector<UsbInterface> list_usb_interfaces(std::filesystem::path const& folder
                                              = "/sys/bus/usb/devices");

} // namespace tractus::drivers
