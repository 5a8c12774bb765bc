#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tractus::drivers {

// A HID usage: the page in the upper 16 bits, the usage's number in the lower 16 (HID Usage Tables
// 1.4). 0 if a field or collection has no usage.
using HidUsage = std::uint32_t;

enum class HidReportKind { Input, Output, Feature };

// A group of related fields (HID 1.11, section 6.2.2.6).
struct HidCollection {
    HidUsage usage = 0;
    std::uint8_t type = 0; // 0 physical, 1 application, 2 logical, …
    // Index in HidReportDescriptor::collections; no value for a top-level collection.
    std::optional<std::size_t> parent;
};

// A number, or an element of an array, in a report. Constant fields are padding and are left out.
struct HidField {
    HidReportKind kind = HidReportKind::Input;
    std::uint8_t report_id = 0; // 0 if the device does not use report ids.
    HidUsage usage = 0;
    // Last usage of an array, whose values are indices into the range from `usage` to this. For
    // other fields equal to `usage`.
    HidUsage usage_maximum = 0;
    // Innermost collection, as an index in HidReportDescriptor::collections.
    std::optional<std::size_t> collection;

    // Offset from the report's first bit, including the report id.
    std::uint32_t bit_offset = 0;
    std::uint32_t bit_size = 0; // 1 to 256; only fields of up to 32 bits can be read as numbers.

    bool is_array = false;
    bool is_relative = false;
    bool has_null_state = false; // True if values outside the logical range mean "no value".

    std::int64_t logical_minimum = 0;
    std::int64_t logical_maximum = 0;
    // Physical range; both limits are 0 if the descriptor gives none.
    std::int64_t physical_minimum = 0;
    std::int64_t physical_maximum = 0;
    std::uint32_t unit = 0; // HID 1.11 section 6.2.2.7, "Unit": one nibble per dimension.
    int unit_exponent = 0;  // Power of ten of the unit, -8 to 7.
};

// The size in bytes of one report, including its report id.
struct HidReportSize {
    HidReportKind kind = HidReportKind::Input;
    std::uint8_t report_id = 0;
    std::size_t bytes = 0;
};

// A device's reports, as flat lists in the descriptor's order.
struct HidReportDescriptor {
    std::vector<HidCollection> collections;
    std::vector<HidField> fields;
    std::vector<HidReportSize> reports;

    // Returns the size of a report in bytes; 0 if there is no such report.
    std::size_t report_size(HidReportKind, std::uint8_t report_id) const;
};

// Parses a report descriptor (HID 1.11, section 6.2.2).
//
// Fails with a device error that names the offset of the invalid item, for: an empty descriptor, a
// truncated item, unbalanced collections or pushes, a report id of 0 or above 255. Memory is
// bounded for any input: descriptors above 64 KiB, reports above 16 KiB, fields above 256 bits,
// more than 64 pushes, and more than 65,536 fields are refused.
//
// Accepts common deviations of real devices: a maximum that fits its item only unsigned (25 FF for
// 255), unit exponents of which only the low nibble counts (FD for D), fewer usages than fields
// (the last one repeats), long items (skipped).
Result<HidReportDescriptor> parse_report_descriptor(std::span<std::byte const> bytes);

// Returns the value of a field in a report, signed if its logical minimum is negative. The field
// must be at most 32 bits wide and lie within the report.
std::int64_t read_field(HidField const&, std::span<std::byte const> report);

// Returns the physical length of the field's logical range, in millimetres. No value if the unit is
// not a length (centimetres or inches) or the range is empty.
std::optional<double> physical_span_mm(HidField const&);

// Returns radians per logical count. No value if the unit is not an angle (degrees or radians) or
// the range is empty.
std::optional<double> radians_per_count(HidField const&);

} // namespace tractus::drivers
