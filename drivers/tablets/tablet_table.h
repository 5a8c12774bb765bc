#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::drivers {

// Steps that the host takes, in this order, so that a tablet leaves the mode in which it powers up,
// which is often that of a mouse.
struct TabletSetup {
    std::vector<int> strings {}; // USB string descriptors: reading them is the switch.
    std::vector<std::vector<std::byte>> feature_reports {}; // Whole reports, the report id first.
    std::vector<std::vector<std::byte>> output_reports {};

    bool empty() const
    {
        return strings.empty() && feature_reports.empty() && output_reports.empty();
    }
};

// A USB string descriptor by which tablets with the same ids are told apart.
struct StringCondition {
    int index = 0;
    std::string pattern {}; // ECMAScript regular expression, which part of the text matches.
};

// One way in which a tablet presents itself. A tablet has several: other firmware, another cable,
// another interface.
struct TabletIdentifier {
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    // Whether it is any product that is not known otherwise, if its longest input report is of
    // `input_size`.
    bool is_any_product = false;
    // The longest of the interface's reports in bytes, the report id's included, which a device
    // that uses no ids counts as well; 0: it has none. No value: not known.
    std::optional<std::size_t> input_size {};
    std::optional<std::size_t> output_size {};

    std::string family {};                      // See drivers/pens/families.h.
    std::vector<StringCondition> conditions {}; // Conditions, all of which must hold.
    TabletSetup setup {};
    std::optional<int> interface_number {}; // Only on this USB interface.
};

// One model of a tablet.
struct Tablet {
    std::string name {}; // "Huion HS610".
    Vec2 size_mm = Vec2::Zero();
    // Whether its size and its maxima do not fit together: where the pen is may be wrong by some
    // per cent, or altogether.
    bool is_size_in_doubt = false;
    std::int32_t x_maximum = 0;
    std::int32_t y_maximum = 0;
    std::int32_t pressure_maximum = 0;
    unsigned pen_buttons = 0;
    unsigned pad_keys = 0;
    std::vector<TabletIdentifier> identifiers {};
};

// The family of an interface of keys or touch, which carries no pen.
inline constexpr std::string_view kPadFamily = "pad";

// Returns all tablets that are known, in the order of drivers/tablets/tablets.txt.
std::span<Tablet const> known_tablets();

// Reads the form that drivers/tablets/tablets.txt explains. Fails, as the station's fault, with the
// line's number.
Result<std::vector<Tablet>> parse_tablets(std::string_view text);

} // namespace tractus::drivers
