#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// The text in a USB string descriptor (USB 2.0 section 9.6.7), in UTF-8; `bytes` is what follows
// its length and type. Never fails: tablets put numbers into such descriptors, so halves of UTF-16
// pairs are kept as UTF-8 would write them, and a last odd byte is dropped.
std::string string_descriptor_text(std::span<std::byte const> bytes);

// The bytes that string_descriptor_text made the text of.
std::vector<std::byte> string_descriptor_bytes(std::string_view text);

// What a tablet says of itself in a string descriptor.
struct TabletParameters {
    std::int32_t x_maximum = 0;
    std::int32_t y_maximum = 0;
    std::int32_t pressure_maximum = 0;
    std::int32_t counts_per_inch = 0;

    Vec2 size_mm() const;

    bool operator==(TabletParameters const&) const = default;
};

// The numbers in string 200 (UC-Logic's second protocol) or 100 (its first, and UGEE's second). No
// value for another string, one that is too short, and one that holds no sensible numbers: a side
// outside 20 to 800 mm, less than 500 or more than 10,500 counts per inch, or no pressure.
std::optional<TabletParameters> parse_parameters(int index, std::string_view text);

} // namespace tractus
