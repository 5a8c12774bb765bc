#pragma once

#include "engine/base/vectors.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace tractus::drivers {

// A tablet's description of itself, contained in a string descriptor.
struct TabletParameters {
    std::int32_t x_maximum = 0;
    std::int32_t y_maximum = 0;
    std::int32_t pressure_maximum = 0;
    std::int32_t counts_per_inch = 0;

    Vec2 size_mm() const;

    bool operator==(TabletParameters const&) const = default;
};

// Parses string 200 (UC-Logic's second protocol) or 100 (its first, and UGEE's second). No value
// for other indices, for texts that are too short, and for implausible numbers: a side outside 20
// to 800 mm, less than 500 or more than 10,500 counts per inch, or no pressure.
std::optional<TabletParameters> parse_parameters(int index, std::string_view text);

} // namespace tractus::drivers
