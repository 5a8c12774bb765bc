#include "drivers/pens/veikk.h"

#include "drivers/reports/report_bytes.h"

#include <array>

namespace tractus::drivers {

namespace {

using Report = std::span<std::byte const>;

constexpr std::size_t kVeikkFlags = 2;

bool is_pen_report(Report report, std::size_t size)
{
    return report.size() >= size && u8(report, 1) == 0x41;
}

// Reads the flags: 0xA0 near, 0xA1 down, 0xC0 gone. Not all tablets set the tip bit.
void read_flags(PenFields& fields, Report report)
{
    fields.in_range = has_bit(report, kVeikkFlags, 5);
    fields.tip = *fields.in_range && (has_bit(report, kVeikkFlags, 0) || *fields.pressure > 0);
    fields.buttons = static_cast<std::uint32_t>(u8(report, kVeikkFlags) >> 1 & 3);
}

// Decodes version 1 with 16-bit axes and pressure, which the A15 also uses.
std::optional<PenFields> decode_16_bit(Report report, FamilyState&)
{
    if (!is_pen_report(report, 9))
        return std::nullopt;
    PenFields fields { .x = u16_le(report, 3),
                       .y = u16_le(report, 5),
                       .pressure = u16_le(report, 7) };
    read_flags(fields, report);
    return fields;
}

std::optional<PenFields> decode_24_bit(Report report, FamilyState&)
{
    if (!is_pen_report(report, 11))
        return std::nullopt;
    PenFields fields { .x = u24_le(report, 3),
                       .y = u24_le(report, 6),
                       .pressure = u16_le(report, 9) };
    read_flags(fields, report);
    return fields;
}

std::optional<PenFields> decode_24_bit_tilt(Report report, FamilyState& state)
{
    if (report.size() < 13)
        return std::nullopt;
    auto fields = decode_24_bit(report, state);
    if (fields)
        fields->tilt_deg = Vec2(s8(report, 11), s8(report, 12));
    return fields;
}

std::optional<PenFields> decode_acepen(Report report, FamilyState& state)
{
    if (report.size() < 11)
        return std::nullopt;
    auto fields = decode_16_bit(report, state);
    if (fields)
        fields->tilt_deg = Vec2(s8(report, 9), s8(report, 10));
    return fields;
}

constexpr std::array kVeikkFamilies {
    PenFamily { .name = "veikk-v1", .decode = decode_16_bit },
    PenFamily { .name = "veikk-a15", .decode = decode_16_bit },
    PenFamily { .name = "veikk", .decode = decode_24_bit },
    PenFamily { .name = "veikk-tilt", .decode = decode_24_bit_tilt, .has_tilt = true },
    PenFamily { .name = "acepen", .decode = decode_acepen, .has_tilt = true },
};

} // namespace

std::span<PenFamily const> veikk_families()
{
    return kVeikkFamilies;
}

} // namespace tractus::drivers
