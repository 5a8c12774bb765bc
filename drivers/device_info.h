#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tractus {

// What is known of a device before its first report, in the words of a hid-recorder file.
struct DeviceInfo {
    std::string name {};     // As the device calls itself.
    std::string location {}; // Where it was opened: "/dev/hidraw3", "FILE:device 1", "simulated".
    std::string physical_path {}; // The kernel's: "usb-0000:00:14.0-2/input1"; may be empty.
    std::uint16_t bus = 3;        // 3 USB, 5 Bluetooth, 6 virtual, 18 I2C (linux/input.h).
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;

    // HID 1.11 section 6.2.2; empty if it could not be read.
    std::vector<std::byte> report_descriptor {};
};

} // namespace tractus
