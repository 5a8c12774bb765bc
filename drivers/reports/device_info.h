#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tractus::drivers {

// Facts about a device that are known before its first report, in the words of a hid-recorder file.
struct DeviceInfo {
    std::string name {};          // The device's own name.
    std::string manufacturer {};  // USB string; may be empty.
    std::string serial_number {}; // USB string; may be empty, and the same in all of its kind.

    // Where it is opened: an address that the command line takes, see drivers/device_address.h
    // ("/dev/hidraw3", "libusb:1-2.3:0", "usb:1-2", "gpio:gpiochip0:11,10,9,8:mcp3208:0"); or where
    // it came from: "FILE:device 1", "simulated".
    std::string location {};

    // Wishes of its user, behind the @ of an address: "GP2,4.096V" (drivers/device_list.h). Empty
    // for what the driver takes by itself.
    std::string settings {};

    // The kernel's: "usb-0000:00:14.0-2/input1"; may be empty. The number behind "/input" is the
    // USB interface's.
    std::string physical_path {};
    int interface_number = -1; // The USB interface; -1 if there is none or it is not known.

    // 3 USB, 5 Bluetooth, 6 virtual, 18 (hexadecimal) I2C, 1c SPI: linux/input.h.
    std::uint16_t bus = 3;
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;

    // HID 1.11 section 6.2.2; empty if it could not be read, and for what is no HID device.
    std::vector<std::byte> report_descriptor {};

    // USB string descriptors that were read at opening, since what the reports mean depends on
    // them: index → text in UTF-8. A log keeps them, so that it decodes as the live device did.
    std::map<int, std::string> strings {};

    // A tablet's active area in millimetres, X then Y, where the kernel's driver for it knows it
    // (drivers/input_size.h). For what neither its descriptor nor our table tells.
    std::optional<Vec2> size_mm {};

    // Troubles at opening that do not keep the device from working after a fashion: each is one
    // sentence for the user. Not in a log.
    std::vector<std::string> warnings {};
};

} // namespace tractus::drivers
