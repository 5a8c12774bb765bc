#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <span>
#include <string>

namespace tractus::drivers {

// Interface for communicating with a tablet: through hidraw, through libusb, or with a tablet
// emulated by a test.
class TabletPort {
public:
    virtual ~TabletPort() = default;

    // Sends a complete report, beginning with its report id. Fails with a device error if the
    // tablet does not accept it.
    virtual Result<void> send_feature(std::span<std::byte const> report) = 0;
    virtual Result<void> send_output(std::span<std::byte const> report) = 0;

    // Returns the text of a USB string descriptor (see string_descriptor_text()); empty if the
    // tablet has none with this index. Fails with a user error if the tablet cannot be asked.
    virtual Result<std::string> read_string(int index) = 0;
};

} // namespace tractus::drivers
