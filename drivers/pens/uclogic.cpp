#include "drivers/pens/uclogic.h"

#include "drivers/reports/report_bytes.h"

#include <array>

namespace tractus::drivers {

namespace {

using Report = std::span<std::byte const>;

constexpr std::size_t kUclogicFlags = 1;

PenFields base_fields(Report report)
{
    return {
        .x = u16_le(report, 2),
        .y = u16_le(report, 4),
        .pressure = u16_le(report, 6),
        .tip = has_bit(report, kUclogicFlags, 0),
        .buttons = static_cast<std::uint32_t>(u8(report, kUclogicFlags) >> 1 & 7),
    };
}

// Decodes any report that begins like UC-Logic's formats, whatever its report id. Some of these
// tablets have no tip bit, so any pressure counts as a touch.
std::optional<PenFields> decode_generic(Report report, FamilyState&)
{
    if (report.size() < 8)
        return std::nullopt;
    auto fields = base_fields(report);
    fields.in_range = !has_bit(report, kUclogicFlags, 6);
    fields.tip = *fields.in_range && (*fields.tip || *fields.pressure > 0);
    return fields;
}

// True for reports of pad keys, dials and touch strips: flags 0xE0, 0xE3, 0xF0, 0xF1, …
bool is_pad_report(Report report)
{
    return (u8(report, kUclogicFlags) & 0xE0) == 0xE0;
}

// Decodes version 1, used after a string descriptor below 200 was read. Flags: 0x80 near, 0x81
// down, 0xC0 gone.
std::optional<PenFields> decode_v1(Report report, FamilyState&)
{
    if (report.size() < 8 || u8(report, 0) != 0x07 || is_pad_report(report))
        return std::nullopt;
    auto fields = base_fields(report);
    fields.in_range = has_bit(report, kUclogicFlags, 7) && !has_bit(report, kUclogicFlags, 6);
    return fields;
}

// Decodes version 1 reports whose in-range bit is not inverted.
std::optional<PenFields> decode_v1_upright(Report report, FamilyState&)
{
    if (report.size() < 8 || is_pad_report(report))
        return std::nullopt;
    auto fields = base_fields(report);
    fields.in_range = has_bit(report, kUclogicFlags, 6);
    return fields;
}

// Decodes version 2, used after string descriptor 200 was read. Flags: 0x80 near, 0x81 down; 0xA0
// and 0xA1 for the eraser. Bytes 8 and 9 are the upper bytes of X and Y. When the pen leaves, some
// tablets send 0x00, others nothing.
std::optional<PenFields> decode_v2(Report report, FamilyState&)
{
    if (report.size() < 12 || u8(report, 0) != 0x08 || is_pad_report(report))
        return std::nullopt;
    auto fields = base_fields(report);
    fields.x |= u8(report, 8) << 16;
    fields.y |= u8(report, 9) << 16;
    fields.in_range = has_bit(report, kUclogicFlags, 7) && !has_bit(report, kUclogicFlags, 6);
    fields.invert = has_bit(report, kUclogicFlags, 5);
    return fields;
}

// Decodes version 2 with tilt, in degrees to the right and away from the user.
std::optional<PenFields> decode_v2_tilt(Report report, FamilyState& state)
{
    auto fields = decode_v2(report, state);
    if (fields)
        fields->tilt_deg = Vec2(s8(report, 10), -s8(report, 11));
    return fields;
}

// Decodes Huion Giano reports, with tilt in degrees to the left and away from the user.
std::optional<PenFields> decode_giano(Report report, FamilyState& state)
{
    auto fields = decode_v2(report, state);
    if (fields)
        fields->tilt_deg = Vec2(-s8(report, 10), -s8(report, 11));
    return fields;
}

constexpr std::array kUclogicFamilies {
    PenFamily { .name = "generic", .decode = decode_generic, .button_count = 3 },
    PenFamily { .name = "uclogic-v1", .decode = decode_v1, .button_count = 3 },
    PenFamily { .name = "uclogic-v1-upright", .decode = decode_v1_upright, .button_count = 3 },
    PenFamily { .name = "uclogic-v2",
                .decode = decode_v2,
                .has_eraser = true,
                .reports_leaving = false,
                .button_count = 3 },
    PenFamily { .name = "uclogic-v2-tilt",
                .decode = decode_v2_tilt,
                .has_tilt = true,
                .has_eraser = true,
                .reports_leaving = false,
                .button_count = 3 },
    PenFamily { .name = "huion-giano",
                .decode = decode_giano,
                .has_tilt = true,
                .has_eraser = true,
                .reports_leaving = false,
                .button_count = 3 },
};

} // namespace

std::span<PenFamily const> uclogic_families()
{
    return kUclogicFamilies;
}

} // namespace tractus::drivers
