#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tractus::drivers {

// Facts about a device that are known before its first report, with the field names of hid-recorder
// files.
struct DeviceInfo {
    std::string name {};          // The name that the device reports.
    std::string manufacturer {};  // USB string; may be empty.
    std::string serial_number {}; // USB string; may be empty, or equal in all devices of a model.

    // Address at which the device can be opened, as the command line accepts it
    // (drivers/reports/device_address.h): "/dev/hidraw3", "libusb:1-2.3:0", "usb:1-2",
    // "gpio:gpiochip0:11,10,9,8:mcp3208:0". For recorded and simulated devices, the origin instead:
    // "FILE:device 1", "simulated".
    std::string location {};

    // Settings chosen by the user, which follow the @ of an address: "GP2,4.096V"
    // (drivers/device_list.h). Empty for the driver's defaults.
    std::string settings {};

    // The kernel's path, "usb-0000:00:14.0-2/input1"; may be empty. The number after "/input" is
    // the USB interface.
    std::string physical_path {};
    // Number of the USB interface; -1 if there is none or it is not known.
    int interface_number = -1;

    // Bus type of linux/input.h: 3 USB, 5 Bluetooth, 6 virtual, 0x18 I2C, 0x1c SPI.
    std::uint16_t bus = 3;
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;

    // Report descriptor (HID 1.11, section 6.2.2); empty if it could not be read, or if this is not
    // a HID device.
    std::vector<std::byte> report_descriptor {};

    // USB string descriptors read when the device was opened, index → text in UTF-8. The decoding
    // of reports can depend on them, so they are kept in logs.
    std::map<int, std::string> strings {};

    // A tablet's active area in millimetres, X then Y, as the kernel's driver reports it
    // (drivers/links/input_size.h). Used if neither the descriptor nor our table contains it.
    std::optional<Vec2> size_mm {};

    // Problems at opening after which the device still works in part; each is one sentence for the
    // user. Not kept in logs.
    std::vector<std::string> warnings {};
};

} // namespace tractus::drivers
