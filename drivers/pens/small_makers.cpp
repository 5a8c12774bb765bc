#include "drivers/pens/small_makers.h"

#include "drivers/reports/report_bytes.h"

#include <array>

namespace tractus::drivers {

namespace {

using Report = std::span<std::byte const>;

std::uint32_t buttons_at(Report report, std::size_t at, unsigned bit)
{
    return static_cast<std::uint32_t>(u8(report, at) >> bit & 3);
}

bool has_id(Report report, std::int32_t id, std::size_t size)
{
    return report.size() >= size && u8(report, 0) == id;
}

// Decodes report 0x10, which the tablets' own descriptors get wrong: flags, X, Y, pressure. Report
// 0x11 is the tablet's mouse.
std::optional<PenFields> decode_genius(Report report, FamilyState&)
{
    if (!has_id(report, 0x10, 8))
        return std::nullopt;
    return PenFields {
        .x = u16_le(report, 2),
        .y = u16_le(report, 4),
        .pressure = u16_le(report, 6),
        .in_range = has_bit(report, 1, 7),
        .tip = has_bit(report, 1, 0),
        .buttons = buttons_at(report, 1, 1),
    };
}

// Decodes Waltop's "tablet mode": X, Y, flags, then pressure, which is valid while the tip is down.
std::optional<PenFields> decode_waltop(Report report, FamilyState&)
{
    if (!has_id(report, 0x02, 8))
        return std::nullopt;
    bool const tip = has_bit(report, 5, 2);
    return PenFields {
        .x = u16_le(report, 1),
        .y = u16_le(report, 3),
        .pressure = tip ? u16_le(report, 6) : 0,
        .tip = tip,
        .buttons = buttons_at(report, 5, 3),
    };
}

// Decodes reports of Lifetec tablets, which are like Waltop's, but without a tip bit. Their tilt is
// an azimuth and an altitude at unknown offsets, and is not decoded.
std::optional<PenFields> decode_lifetec(Report report, FamilyState&)
{
    if (!has_id(report, 0x02, 8))
        return std::nullopt;
    return PenFields {
        .x = u16_le(report, 1),
        .y = u16_le(report, 3),
        .pressure = u16_le(report, 6),
        .buttons = buttons_at(report, 5, 3),
    };
}

// Decodes Robotpen's reports. Byte 1 is 0x42 while the pen is near. One bit of the pressure may be
// the button; it is not decoded as a button.
std::optional<PenFields> decode_robotpen(Report report, FamilyState&)
{
    if (report.size() < 12)
        return std::nullopt;
    return PenFields {
        .x = u16_le(report, 6),
        .y = u16_le(report, 8),
        .pressure = u16_le(report, 10),
        .in_range = u8(report, 1) == 0x42,
    };
}

// Decodes ViewSonic Woodpad reports. Bits 0 and 1 of the flags are set while the pen is near.
std::optional<PenFields> decode_woodpad(Report report, FamilyState&)
{
    if (report.size() < 14)
        return std::nullopt;
    bool const tip = has_bit(report, 9, 2);
    return PenFields {
        .x = u16_le(report, 1),
        .y = u16_le(report, 5),
        .pressure = tip ? u16_le(report, 10) : 0,
        .tilt_deg = Vec2(s8(report, 12), s8(report, 13)),
        .in_range = (u8(report, 9) & 3) == 3,
        .tip = tip,
        .buttons = buttons_at(report, 9, 3),
    };
}

// Decodes Floogoo reports, whose tilt is in hundredths of a degree.
std::optional<PenFields> decode_floogoo(Report report, FamilyState&)
{
    if (!has_id(report, 0x01, 12))
        return std::nullopt;
    auto const tilt_deg
        = [&](std::size_t at) { return static_cast<std::int16_t>(u16_le(report, at)) * 0.01; };
    return PenFields {
        .x = u16_le(report, 2),
        .y = u16_le(report, 4),
        .pressure = u16_le(report, 6),
        .tilt_deg = Vec2(tilt_deg(8), tilt_deg(10)),
        .in_range = has_bit(report, 1, 5),
        .invert = has_bit(report, 1, 3),
        .buttons = buttons_at(report, 1, 1),
    };
}

constexpr std::array kSmallMakersFamilies {
    PenFamily { .name = "genius", .decode = decode_genius },
    PenFamily { .name = "waltop", .decode = decode_waltop, .reports_leaving = false },
    PenFamily { .name = "lifetec", .decode = decode_lifetec, .reports_leaving = false },
    PenFamily { .name = "robotpen", .decode = decode_robotpen, .button_count = 0 },
    PenFamily { .name = "woodpad", .decode = decode_woodpad, .has_tilt = true },
    PenFamily { .name = "floogoo", .decode = decode_floogoo, .has_tilt = true, .has_eraser = true },
};

} // namespace

std::span<PenFamily const> small_makers_families()
{
    return kSmallMakersFamilies;
}

} // namespace tractus::drivers
