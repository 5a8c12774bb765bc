#pragma once

#include <cstdint>

namespace tractus::sim {

// The eight bytes that begin a control transfer (USB 2.0 section 9.3).
struct UsbSetup {
    std::uint8_t request_type = 0; // bmRequestType; with bit 7 the device sends the data.
    std::uint8_t request = 0;      // bRequest
    std::uint16_t value = 0;
    std::uint16_t index = 0;
    std::uint16_t length = 0;
};

} // namespace tractus::sim
