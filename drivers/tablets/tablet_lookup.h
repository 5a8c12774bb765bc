#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/tablets/tablet_table.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tractus::drivers {

// The tablet that a device was identified as. The pointers are never null, and valid for the whole
// run of the program.
struct TabletMatch {
    Tablet const* tablet = nullptr;
    TabletIdentifier const* identifier = nullptr;

    // Number of other models, of another size or format, that match equally well. 0 if it is
    // certainly this model, or one that sends the same reports.
    std::size_t alternatives = 0;

    // Proportions of the active area; no value if matching models differ in them.
    std::optional<double> width_to_height {};
};

// Identifies a device by its ids, its strings and the lengths of its reports. The match may also be
// the interface of a tablet's keys (kPadFamily). No value if no known tablet has the device's ids.
//
// Many models share ids. They are distinguished by, strongest first: a string in
// DeviceInfo::strings; the maxima in string 200 or 100; the model's name within the device's name;
// the lengths of the longest input and output reports in the descriptor (which is wrong on some
// tablets). If none of these decides, the shape that most models have is taken, and the first model
// with that shape. The same happens if the strings match no model, because new models appear with
// the ids of old ones and differ little from them.
std::optional<TabletMatch> find_tablet(DeviceInfo const& info);

// Identifies a device in the given table.
std::optional<TabletMatch> find_tablet(std::span<Tablet const> tablets, DeviceInfo const& info);

// Returns the name of a match for the user: "Huion HS610", or "Huion H640P (or one of 21 others
// with its ids)".
std::string tablet_name(TabletMatch const& match);

// Returns the indices of the USB string descriptors that distinguish models with these ids, in
// ascending order.
std::vector<int> identifying_strings(std::uint16_t vendor_id, std::uint16_t product_id);

} // namespace tractus::drivers
