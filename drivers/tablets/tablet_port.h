#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <span>
#include <string>

namespace tractus::drivers {

// How one speaks to a tablet: through hidraw, through libusb, or to one that a test plays.
class TabletPort {
public:
    virtual ~TabletPort() = default;

    // Whole reports, the report id first. Fail, as the device's fault, if it does not take them.
    virtual Result<void> send_feature(std::span<std::byte const> report) = 0;
    virtual Result<void> send_output(std::span<std::byte const> report) = 0;

    // The text of a USB string descriptor (see string_descriptor_text); empty if the tablet has
    // none of this index. Fails, as the user's fault, if it cannot be asked at all.
    virtual Result<std::string> read_string(int index) = 0;
};

} // namespace tractus::drivers
