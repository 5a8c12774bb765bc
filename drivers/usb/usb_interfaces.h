#pragma once

#include "drivers/reports/device_info.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::drivers {

// One interface of a USB device.
struct UsbInterface {
    std::filesystem::path folder {}; // Folder of the interface in sysfs: ".../1-2.3:1.0".
    std::string port {};             // Port, such as "1-2.3".

    // Class of the interface (USB 2.0, section 9.6.5): 3 is HID, 255 is vendor-specific.
    int usb_class = 0;
    int subclass = 0;
    int protocol = 0;

    // Names, ids, interface number and physical path. The location is empty; the driver that opens
    // the interface sets it.
    DeviceInfo info {};

    // Returns the folder of the device in sysfs, with its names and ids.
    std::filesystem::path device_folder() const { return folder.parent_path() / port; }
};

// Lists every interface of every USB device, sorted by port and number. Reads only sysfs, which
// needs no permission; fields that cannot be read stay empty.
std::vector<UsbInterface> list_usb_interfaces(std::filesystem::path const& folder
                                              = "/sys/bus/usb/devices");

} // namespace tractus::drivers
