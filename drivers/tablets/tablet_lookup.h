#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/tablets/tablet_table.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tractus::drivers {

// A tablet that a device is. The pointers are never null; both live as long as the program.
struct TabletMatch {
    Tablet const* tablet = nullptr;
    TabletIdentifier const* identifier = nullptr;

    // How many other models, of another size or format, would fit what is known of the device as
    // well. 0: it is this one, or one that cannot be told from it by its reports.
    std::size_t alternatives = 0;

    // The proportions of the active area, where all models that would fit agree on them.
    std::optional<double> width_to_height {};
};

// Looks a device up by its ids, its strings and the lengths of its reports; it may also be found to
// be the interface of a tablet's keys (kPadFamily). No value if no known tablet has its ids.
//
// Many models share ids. What tells them apart, the strongest first: a string in
// DeviceInfo::strings, the maxima that string 200 or 100 tells, the model's name in the device's,
// the longest input and output report that the descriptor has (which some get wrong). Where none
// does, the shape that most of the models have is taken, and of those the first. So it is if the
// strings are of none of them: new models come with old ids, and differ little.
std::optional<TabletMatch> find_tablet(DeviceInfo const& info);

// Looks in a table of one's own.
std::optional<TabletMatch> find_tablet(std::span<Tablet const> tablets, DeviceInfo const& info);

// The name of a match for a person to read: "Huion HS610", or "Huion H640P (or one of 21 others
// with its ids)".
std::string tablet_name(TabletMatch const& match);

// The USB string descriptors that tell apart the models with these ids, in ascending order.
std::vector<int> identifying_strings(std::uint16_t vendor_id, std::uint16_t product_id);

} // namespace tractus::drivers
