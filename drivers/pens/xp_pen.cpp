#include "drivers/pens/xp_pen.h"

#include "drivers/reports/report_bytes.h"

#include <array>

namespace tractus::drivers {

namespace {

using Report = std::span<std::byte const>;

constexpr std::size_t kXpPenFlags = 1;
constexpr std::int32_t kGone = 0xC0;

// Flags, then X, Y and pressure; from 10 bytes on the tilt, from 12 on the upper bytes of X and Y.
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

// A0 near, A1 down; with bit 3 the eraser's end. Gone is C0, with some tablets 80. Bit 4 is in the
// reports of keys, dials and batteries.
std::optional<PenFields> decode_xp_pen(Report report, FamilyState&)
{
    if (report.size() < 8 || has_bit(report, kXpPenFlags, 4))
        return std::nullopt;
    auto fields = xp_pen_fields(report);
    fields.in_range = has_bit(report, kXpPenFlags, 5);
    fields.invert = has_bit(report, kXpPenFlags, 3);
    return fields;
}

// The pressure's upper bits mean something else.
std::optional<PenFields> decode_offset_pressure(Report report, FamilyState& state)
{
    auto fields = decode_xp_pen(report, state);
    if (fields)
        *fields->pressure &= 0x1FFF;
    return fields;
}

// 16,384 levels of pressure, whose highest bit is in byte 13.
std::optional<PenFields> decode_gen2(Report report, FamilyState& state)
{
    if (report.size() < 14)
        return std::nullopt;
    auto fields = decode_xp_pen(report, state);
    if (fields)
        *fields->pressure = (*fields->pressure & 0xBFFF) | (u8(report, 13) & 1) << 13;
    return fields;
}

// 80 near, 81 down: here bit 5 is in the reports of keys.
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
    if (report.size() < 10 || (u8(report, kXpPenFlags) & 0xF0) == 0xF0) // Keys.
        return std::nullopt;
    auto fields = xp_pen_fields(report);
    fields.in_range = has_bit(report, kXpPenFlags, 5);
    fields.invert = *fields.in_range && has_bit(report, kXpPenFlags, 6);
    fields.buttons = static_cast<std::uint32_t>(u8(report, kXpPenFlags) >> 1 & 7);
    return fields;
}

// Report 1; gone if it has no flags at all.
std::optional<PenFields> decode_xenx(Report report, FamilyState&)
{
    if (report.size() < 8 || u8(report, 0) != 0x01)
        return std::nullopt;
    auto fields = xp_pen_fields(report.first(8)); // The rest of 64 bytes says nothing of the pen.
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
