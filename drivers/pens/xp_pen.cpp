#include "drivers/pens/xp_pen.h"

#include "drivers/reports/report_bytes.h"

#include <array>

namespace tractus::drivers {

namespace {

using Report = std::span<std::byte const>;

constexpr std::size_t kXpPenFlags = 1;
constexpr std::int32_t kGone = 0xC0;

// Reads flags, X, Y and pressure. Reports from 10 bytes on also have tilt, and from 12 bytes on the
// upper bytes of X and Y.
PenFields xp_pen_fields(Report report)
{
    PenFields fields {
        .x = u16_le(report, 2),
        .y = u16_le(report, 4),
        .pressure = u16_le(report, 6),
        .tip = has_bit(report, kXpPenFlags, 0),
        .buttons = static_cast<std::uint32_t>(u8(report, kXpPenFlags) >> 1 & 3),
    };
    if (report.size() >= 10)
        fields.tilt_deg = Vec2(s8(report, 8), s8(report, 9));
    if (report.size() >= 12) {
        fields.x |= u8(report, 10) << 16;
        fields.y |= u8(report, 11) << 16;
    }
    return fields;
}

// Decodes XP-Pen reports. Flags: 0xA0 near, 0xA1 down; bit 3 for the eraser; 0xC0, or 0x80 on some
// tablets, when the pen leaves. Bit 4 marks reports of keys, dials and batteries.
std::optional<PenFields> decode_xp_pen(Report report, FamilyState&)
{
    if (report.size() < 8 || has_bit(report, kXpPenFlags, 4))
        return std::nullopt;
    auto fields = xp_pen_fields(report);
    fields.in_range = has_bit(report, kXpPenFlags, 5);
    fields.invert = has_bit(report, kXpPenFlags, 3);
    return fields;
}

// Decodes reports with 13 bits of pressure; the upper bits of the field have another meaning.
std::optional<PenFields> decode_offset_pressure(Report report, FamilyState& state)
{
    auto fields = decode_xp_pen(report, state);
    if (fields)
        *fields->pressure &= 0x1FFF;
    return fields;
}

// Decodes reports with 16,384 levels of pressure, whose highest bit is in byte 13.
std::optional<PenFields> decode_gen2(Report report, FamilyState& state)
{
    if (report.size() < 14)
        return std::nullopt;
    auto fields = decode_xp_pen(report, state);
    if (fields)
        *fields->pressure = (*fields->pressure & 0xBFFF) | (u8(report, 13) & 1) << 13;
    return fields;
}

// Decodes reports with flags 0x80 near and 0x81 down, in which bit 5 marks reports of keys.
std::optional<PenFields> decode_offset_keys(Report report, FamilyState&)
{
    if (report.size() < 8 || has_bit(report, kXpPenFlags, 5))
        return std::nullopt;
    auto fields = xp_pen_fields(report);
    fields.in_range = u8(report, kXpPenFlags) != kGone;
    return fields;
}

std::optional<PenFields> decode_xencelabs(Report report, FamilyState&)
{
    if (report.size() < 10 || (u8(report, kXpPenFlags) & 0xF0) == 0xF0) // A report of the keys.
        return std::nullopt;
    auto fields = xp_pen_fields(report);
    fields.in_range = has_bit(report, kXpPenFlags, 5);
    fields.invert = *fields.in_range && has_bit(report, kXpPenFlags, 6);
    fields.buttons = static_cast<std::uint32_t>(u8(report, kXpPenFlags) >> 1 & 7);
    return fields;
}

// Decodes XENX reports: report 1; its flags are 0 when the pen has left.
std::optional<PenFields> decode_xenx(Report report, FamilyState&)
{
    if (report.size() < 8 || u8(report, 0) != 0x01)
        return std::nullopt;
    auto fields
        = xp_pen_fields(report.first(8)); // The remaining bytes (of 64) are not about the pen.
    fields.in_range = u8(report, kXpPenFlags) != 0;
    fields.tip = *fields.in_range && *fields.pressure > 0;
    fields.invert = has_bit(report, kXpPenFlags, 6);
    return fields;
}

constexpr std::array kXpPenFamilies {
    PenFamily { .name = "xp-pen", .decode = decode_xp_pen, .has_tilt = true, .has_eraser = true },
    PenFamily { .name = "xp-pen-offset-pressure",
                .decode = decode_offset_pressure,
                .has_tilt = true,
                .has_eraser = true },
    PenFamily {
        .name = "xp-pen-gen2", .decode = decode_gen2, .has_tilt = true, .has_eraser = true },
    PenFamily { .name = "xp-pen-offset-keys", .decode = decode_offset_keys },
    PenFamily { .name = "xencelabs",
                .decode = decode_xencelabs,
                .has_tilt = true,
                .has_eraser = true,
                .button_count = 3 },
    PenFamily { .name = "xenx", .decode = decode_xenx, .has_eraser = true },
};

} // namespace

std::span<PenFamily const> xp_pen_families()
{
    return kXpPenFamilies;
}

} // namespace tractus::drivers
