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

// Whatever begins like these formats, and says no more than its flags. Some of these tablets have
// no tip bit.
std::optional<PenFields> decode_generic(Report report, FamilyState&)
{
    if (report.size() < 8)
        return std::nullopt;
    auto fields = base_fields(report);
    fields.in_range = !has_bit(report, kUclogicFlags, 6);
    fields.tip = *fields.in_range && (*fields.tip || *fields.pressure > 0);
    return fields;
}

bool is_pad_report(Report report) // Keys, dials and touch strips: E0, E3, F0, F1…
{
    return (u8(report, kUclogicFlags) & 0xE0) == 0xE0;
}

// Version 1, after a string descriptor below 200 was read: 80 near, 81 down, C0 gone.
std::optional<PenFields> decode_v1(Report report, FamilyState&)
{
    if (report.size() < 8 || u8(report, 0) != 0x07 || is_pad_report(report))
        return std::nullopt;
    auto fields = base_fields(report);
    fields.in_range = has_bit(report, kUclogicFlags, 7) && !has_bit(report, kUclogicFlags, 6);
    return fields;
}

// Decodes reports with the bit the other way round.
std::optional<PenFields> decode_v1_upright(Report report, FamilyState&)
{
    if (report.size() < 8 || is_pad_report(report))
        return std::nullopt;
    auto fields = base_fields(report);
    fields.in_range = has_bit(report, kUclogicFlags, 6);
    return fields;
}

// Version 2, after string descriptor 200 was read: 80 near, 81 down; A0 and A1 with the eraser's
// end. Bytes 8 and 9 are the upper ones of X and Y. Some tablets send 00 when the pen leaves, some
// nothing.
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

// Degrees to the right, and away from the user.
std::optional<PenFields> decode_v2_tilt(Report report, FamilyState& state)
{
    auto fields = decode_v2(report, state);
    if (fields)
        fields->tilt_deg = Vec2(s8(report, 10), -s8(report, 11));
    return fields;
}

// Degrees to the left, and away from the user.
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
