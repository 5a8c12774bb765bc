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

// Steps that switch a tablet from its power-up mode, in which it often acts as a mouse, to its full
// mode. They are performed in the order of the members.
struct TabletSetup {
    std::vector<int> strings {}; // USB string descriptors; reading them switches the tablet.
    // Complete reports, each beginning with its report id.
    std::vector<std::vector<std::byte>> feature_reports {};
    std::vector<std::vector<std::byte>> output_reports {};

    bool empty() const
    {
        return strings.empty() && feature_reports.empty() && output_reports.empty();
    }
};

// A USB string descriptor that distinguishes tablets with the same ids.
struct StringCondition {
    int index = 0;
    std::string pattern {}; // ECMAScript regular expression; it may match a part of the text.
};

// One way in which a tablet presents itself on the bus. A tablet has several, for different
// firmware, cables or interfaces.
struct TabletIdentifier {
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    // True: matches all otherwise unknown products whose longest input report has `input_size`.
    bool is_any_product = false;
    // Lengths in bytes of the interface's longest input and output report, counting a report id
    // even if the device uses none. 0: there is no such report. No value: not known.
    std::optional<std::size_t> input_size {};
    std::optional<std::size_t> output_size {};

    std::string family {}; // Name of the report format; see drivers/pens/families.h.
    std::vector<StringCondition> conditions {}; // Conditions that must all hold.
    TabletSetup setup {};
    std::optional<int> interface_number {}; // If set, matches only this USB interface.
};

// A tablet model with its properties.
struct Tablet {
    std::string name {}; // Name with its maker, such as "Huion HS610".
    Vec2 size_mm = Vec2::Zero();
    // True if the size and the maxima contradict each other, so that positions may be wrong by some
    // per cent, or completely.
    bool is_size_in_doubt = false;
    std::int32_t x_maximum = 0;
    std::int32_t y_maximum = 0;
    std::int32_t pressure_maximum = 0;
    unsigned pen_buttons = 0;
    unsigned pad_keys = 0;
    std::vector<TabletIdentifier> identifiers {};
};

// The family of an interface for keys or touch, which carries no pen data.
inline constexpr std::string_view kPadFamily = "pad";

// Returns all known tablets, in the order of drivers/tablets/tablets.txt.
std::span<Tablet const> known_tablets();

// Parses the format that drivers/tablets/tablets.txt explains. Fails with a station error that
// names the line's number.
Result<std::vector<Tablet>> parse_tablets(std::string_view text);

} // namespace tractus::drivers
