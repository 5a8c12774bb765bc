#pragma once

#include <cstdint>

namespace tractus::sim {

// The first eight bytes of a control transfer (USB 2.0, section 9.3).
struct UsbSetup {
    // Field bmRequestType; bit 7 set means that the device sends the data.
    std::uint8_t request_type = 0;
    std::uint8_t request = 0; // Field bRequest of the USB specification.
    std::uint16_t value = 0;
    std::uint16_t index = 0;
    std::uint16_t length = 0;
};

} // namespace tractus::sim
