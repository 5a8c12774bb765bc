#include "drivers/pens/wacom.h"

#include "drivers/reports/report_bytes.h"

namespace tractus::drivers {

namespace {

using namespace std::chrono_literals;

using Report = std::span<std::byte const>;
using Fields = std::optional<PenFields>;

constexpr std::uint8_t kPenReport = 0x02;
// Report id of a second kind of pen report; the format IntuosV2 uses it, too.
constexpr std::uint8_t kSecondPenReport = 0x10;
constexpr std::uint8_t kLongPenReport = 0x1E;
constexpr std::uint8_t kShortPenReport = 0x1F;

PenFields const kAway { .carries_position = false, .in_range = false, .tip = false };

// Decodes reports of PenPartner, Graphire and the first Bamboos: 8 or 9 bytes. They can also report
// a mouse on the tablet, and the tablet's keys when no pen is near; both are ignored.
Fields decode_graphire(Report report, FamilyState&)
{
    if (report.size() < 8 || u8(report, 0) != kPenReport)
        return std::nullopt;
    bool const is_mouse = has_bit(report, 1, 6);
    if (!has_bit(report, 1, 7) || is_mouse)
        return kAway;
    bool const touches = has_bit(report, 1, 0);
    return PenFields {
        .x = u16_le(report, 2),
        .y = u16_le(report, 4),
        .pressure = touches ? u8(report, 6) | (u8(report, 7) & 3) << 8 : 0,
        .in_range = true,
        .tip = touches,
        .invert = has_bit(report, 1, 5),
        .buttons = bits(report, 1, 1, 2),
    };
}

// Decodes Graphire reports over Bluetooth (CTE-630BT), which differ from USB in the report id and
// in the pressure's ninth bit, which is among the flags (wacom_graphire_irq in Linux).
Fields decode_graphire_bluetooth(Report report, FamilyState&)
{
    constexpr std::uint8_t kBluetoothPenReport = 0x03;
    if (report.size() < 8 || u8(report, 0) != kBluetoothPenReport)
        return std::nullopt;
    bool const is_mouse = has_bit(report, 1, 6);
    if (!has_bit(report, 1, 7) || is_mouse)
        return kAway;
    bool const touches = has_bit(report, 1, 0);
    return PenFields {
        .x = u16_le(report, 2),
        .y = u16_le(report, 4),
        .pressure = touches ? u8(report, 6) | int { has_bit(report, 1, 3) } << 8 : 0,
        .in_range = true,
        .tip = touches,
        .invert = has_bit(report, 1, 5),
        .buttons = bits(report, 1, 1, 2),
    };
}

// Decodes reports of the Bamboo Pad: report 0x10, in which byte 1 distinguishes the pen from the
// touch pad and the keys.
Fields decode_bamboo_pad(Report report, FamilyState&)
{
    if (report.size() < 9 || u8(report, 0) != kSecondPenReport || u8(report, 1) != 0x01)
        return std::nullopt;
    if (!has_bit(report, 2, 5))
        return kAway;
    return PenFields {
        .x = u16_le(report, 3),
        .y = u16_le(report, 5),
        .pressure = u16_le(report, 7),
        .in_range = true,
        .tip = has_bit(report, 2, 0) || u16_le(report, 7) > 0,
        .invert = has_bit(report, 2, 3),
        .buttons = bits(report, 2, 1, 1),
    };
}

// Decodes reports of Intuos CTL and CTH, and of the Bamboos before them: 8 to 10 bytes. Beyond the
// surface's edge the position is clamped to it. Longer reports with the same id are about fingers.
Fields decode_intuos(Report report, FamilyState&)
{
    if (report.size() < 8 || report.size() > 10 || u8(report, 0) != kPenReport)
        return std::nullopt;
    if (!has_bit(report, 1, 5))
        return kAway;
    return PenFields {
        .x = u16_le(report, 2),
        .y = u16_le(report, 4),
        .pressure = u16_le(report, 6),
        .in_range = true,
        .tip = has_bit(report, 1, 0),
        .invert = has_bit(report, 1, 3),
        .buttons = bits(report, 1, 1, 2),
    };
}

// Reads the report with which a tool arrives: its type in 20 bits, its serial number in 32.
void enter_intuos_pro(Report report, FamilyState& state)
{
    auto const byte = [&](std::size_t i) { return static_cast<std::uint32_t>(u8(report, i)); };
    state.tool_serial
        = (byte(3) & 0x0F) << 28 | byte(4) << 20 | byte(5) << 12 | byte(6) << 4 | byte(7) >> 4;
    state.tool_type = (byte(8) & 0xF0) << 8 | (byte(7) & 0x0F) << 16 | byte(2) << 4 | byte(3) >> 4;
    state.is_eraser = has_bit(report, 3, 7);
    state.buttons = 0;
    state.is_pen = true;
}

Vec2 intuos_pro_tilt_deg(Report report)
{
    return { ((u8(report, 7) << 1 & 0x7E) | u8(report, 8) >> 7) - 64, (u8(report, 8) & 0x7F) - 64 };
}

// Meaning of four bits of a report, which give its kind. In reports of an ordinary pen these bits
// include the buttons.
enum class IntuosProKind { Pen, Rotation, Airbrush, Other };

IntuosProKind kind_of(Report report)
{
    auto const kind = (u8(report, 1) >> 1) & 0x0F;
    switch (kind) {
    case 0x00:
    case 0x01:
    case 0x02:
    case 0x03:
        return IntuosProKind::Pen;
    case 0x05: // Every second report of the Art Pen; it does not change pressure or tilt.
        return IntuosProKind::Rotation;
    case 0x0A: // Every second report of the airbrush, with its wheel.
        return IntuosProKind::Airbrush;
    default: // Reports of mice and lens cursors.
        return IntuosProKind::Other;
    }
}

PenFields intuos_pro_fields(Report report, FamilyState& state)
{
    PenFields fields {
        .x = u16_be(report, 2) << 1 | int { has_bit(report, 9, 1) },
        .y = u16_be(report, 4) << 1 | int { has_bit(report, 9, 0) },
        .in_range = true,
        .invert = state.is_eraser,
        .tool_serial = state.tool_serial,
        .tool_type = state.tool_type,
    };
    auto const kind = kind_of(report);
    if (kind == IntuosProKind::Pen) {
        fields.pressure
            = u8(report, 6) << 3 | (u8(report, 7) & 0xC0) >> 5 | int { has_bit(report, 1, 0) };
        state.buttons = bits(report, 1, 1, 2);
    }
    if (kind != IntuosProKind::Rotation)
        fields.tilt_deg = intuos_pro_tilt_deg(report);
    fields.buttons = state.buttons;
    return fields;
}

// True if the pen draws at the right edge of an Intuos5 or Pro. There the tablet falsely reports
// that the pen is too high.
bool presses_at_right_edge(Report report, FamilyState const& state)
{
    constexpr int kSurely = 10; // Pressure above the noise of the sensor, in counts.
    auto const x = u16_be(report, 2) << 1 | int { has_bit(report, 9, 1) };
    auto const pressure
        = u8(report, 6) << 3 | (u8(report, 7) & 0xC0) >> 5 | int { has_bit(report, 1, 0) };
    return kind_of(report) == IntuosProKind::Pen && pressure > kSurely && state.x_maximum > 0
        && x >= state.x_maximum;
}

// Decodes reports of Intuos 1 to 5 and Pro, the Cintiqs of their time, CTL-490 and its relatives:
// 10 bytes. One report announces a tool, the following ones its movements; pressure indicates
// touch. Longer reports with the same ids are about fingers.
Fields decode_intuos_pro(Report report, FamilyState& state)
{
    if (report.size() != 10 || (u8(report, 0) != kPenReport && u8(report, 0) != kSecondPenReport))
        return std::nullopt;
    auto const flags = u8(report, 1);
    if ((flags & 0xFC) == 0xC0) {
        enter_intuos_pro(report, state);
        return std::nullopt;
    }
    bool const is_near = has_bit(report, 1, 6); // False: the pen is too high for a valid position.
    if (!has_bit(report, 1, 7) || !(is_near || presses_at_right_edge(report, state))) {
        if ((flags & 0xFE) == 0x80)
            state.forget_tool();
        return kAway;
    }
    auto const kind = kind_of(report);
    if (kind != IntuosProKind::Rotation)
        state.is_pen = kind != IntuosProKind::Other;
    if (!state.is_pen)
        return kAway;
    return intuos_pro_fields(report, state);
}

// Where a report of the format IntuosV2 has its values: byte offsets, and bits of the byte `flags`.
struct WideLayout {
    std::size_t flags = 0;
    unsigned eraser_bit = 0;
    unsigned near_bit = 0;
    unsigned button_count = 2;
    std::size_t x = 0;
    std::size_t y = 0;
    std::size_t pressure = 0;
    std::size_t tilt_x = 0;
    std::size_t tilt_y = 0;
};

PenFields wide_fields(Report report, WideLayout const& at)
{
    return {
        .x = u24_le(report, at.x),
        .y = u24_le(report, at.y),
        .pressure = u16_le(report, at.pressure),
        .tilt_deg = Vec2(s8(report, at.tilt_x), s8(report, at.tilt_y)),
        .in_range = true,
        .tip = has_bit(report, at.flags, 0),
        .invert = has_bit(report, at.flags, at.eraser_bit),
        .buttons = bits(report, at.flags, 1, at.button_count),
    };
}

// Decodes reports of the second Intuos Pro (PTH-x60), of CTL-4100 and its relatives, and of the
// Wacom One. The axes of all of these have 24 bits.
Fields decode_intuos_v2(Report report, FamilyState&)
{
    static constexpr WideLayout kPlain { .flags = 1,
                                         .eraser_bit = 4,
                                         .near_bit = 5,
                                         .x = 2,
                                         .y = 5,
                                         .pressure = 8,
                                         .tilt_x = 10,
                                         .tilt_y = 11 };
    static constexpr WideLayout kShifted { .flags = 2,
                                           .eraser_bit = 4,
                                           .near_bit = 5,
                                           .button_count = 3,
                                           .x = 3,
                                           .y = 6,
                                           .pressure = 9,
                                           .tilt_x = 11,
                                           .tilt_y = 12 };
    if (report.size() < 13
        || (u8(report, 0) != kSecondPenReport && u8(report, 0) != kLongPenReport))
        return std::nullopt;
    auto const& at = u8(report, 0) == kSecondPenReport ? kPlain : kShifted;
    return has_bit(report, at.flags, at.near_bit) ? wide_fields(report, at) : kAway;
}

// Decodes reports of the third Intuos Pro, the Movink and the second Wacom One. Short reports have
// axes of 16 bits.
Fields decode_intuos_v3(Report report, FamilyState&)
{
    if (report.size() < 15)
        return std::nullopt;
    bool const is_short = u8(report, 0) == kShortPenReport && u8(report, 1) == 1;
    if (u8(report, 0) != kLongPenReport && !is_short)
        return std::nullopt;
    if (!has_bit(report, 2, 6))
        return kAway;
    PenFields fields { .in_range = true,
                       .tip = has_bit(report, 2, 0),
                       .invert = has_bit(report, 2, 5),
                       .eraser_touch = has_bit(report, 2, 4),
                       .buttons = bits(report, 2, 1, 3) };
    if (is_short) {
        fields.x = u16_le(report, 3);
        fields.y = u16_le(report, 5);
        fields.pressure = u16_le(report, 7);
        fields.tilt_deg = Vec2(s8(report, 9), s8(report, 11));
    } else {
        fields.x = u24_le(report, 3);
        fields.y = u24_le(report, 6);
        fields.pressure = u16_le(report, 9);
        fields.tilt_deg = Vec2(s16_le(report, 11), s16_le(report, 13));
    }
    return fields;
}

// Decodes reports of PTU-600 and the DTU displays: 8 bytes.
Fields decode_dtu(Report report, FamilyState&)
{
    if (report.size() < 8 || u8(report, 0) != kPenReport)
        return std::nullopt;
    if (!has_bit(report, 1, 5))
        return kAway;
    return PenFields {
        .x = u16_le(report, 2),
        .y = u16_le(report, 4),
        .pressure = u16_le(report, 6),
        .in_range = true,
        .tip = has_bit(report, 1, 0),
        .invert = has_bit(report, 1, 3),
        .eraser_touch = has_bit(report, 1, 2),
        .buttons = bits(report, 1, 1, 1) | bits(report, 1, 4, 1) << 1,
    };
}

// Decodes reports of the DTU-1031: report 0x11 with big-endian axes and pressure; the tool's kind
// is a two-bit number. The tablet's keys are in report 0x15 (wacom_dtus_irq in Linux).
Fields decode_dtus(Report report, FamilyState& state)
{
    constexpr std::uint8_t kDtusPenReport = 0x11;
    if (report.size() < 7 || u8(report, 0) != kDtusPenReport)
        return std::nullopt;
    if (!has_bit(report, 1, 7)) {
        state.forget_tool();
        return kAway;
    }
    auto const tool = bits(report, 1, 3, 2);
    if (tool == 1 || tool == 2)
        state.is_eraser = tool == 1;
    return PenFields {
        .x = u16_be(report, 3),
        .y = u16_be(report, 5),
        .pressure = (u8(report, 1) & 3) << 8 | u8(report, 2),
        .in_range = true,
        .invert = state.is_eraser,
        .buttons = bits(report, 1, 5, 2),
    };
}

// Decodes reports of the PL displays: 8 bytes with seven bits each. The eraser and the second
// button share one bit: a pen that arrives with the bit set shows its eraser end.
Fields decode_pl(Report report, FamilyState& state)
{
    if (report.size() < 8 || u8(report, 0) != kPenReport)
        return std::nullopt;
    if (!has_bit(report, 1, 6)) {
        state.forget_tool();
        return kAway;
    }
    bool const eraser_or_second = has_bit(report, 4, 5);
    if (!state.is_inside) {
        state.is_inside = true;
        state.is_eraser = eraser_or_second;
    }
    // An eraser's bit stays set until the eraser leaves.
    state.is_eraser = state.is_eraser && eraser_or_second;
    auto const flags = u8(report, 4);
    return PenFields {
        .x = (u8(report, 1) & 3) << 14 | u8(report, 2) << 7 | u8(report, 3),
        .y = (flags & 3) << 14 | u8(report, 5) << 7 | u8(report, 6),
        .pressure = (u8(report, 7) ^ 0x40) << 2 | (flags & 0x40) >> 5 | (flags & 4) >> 2,
        .in_range = true,
        .tip = has_bit(report, 4, 3),
        .invert = state.is_eraser,
        .buttons = bits(report, 4, 4, 1) | (eraser_or_second && !state.is_eraser ? 2u : 0u),
    };
}

// Layout of a Bluetooth report, as in Linux's wacom driver (wacom_intuos_pro2_bt_pen): the pen's
// states since the previous report, in frames of one layout, followed by the pen's serial number
// and type.
struct BluetoothLayout {
    std::size_t frames = 0;
    std::size_t frame_bytes = 0;
    bool has_tilt = false;

    std::size_t serial() const { return 1 + frames * frame_bytes; }
    std::size_t tool_type() const { return serial() + 8; }
};

PenFields bluetooth_fields(Report report, Report frame, BluetoothLayout const& layout)
{
    bool const is_near = has_bit(frame, 0, 6) && has_bit(frame, 0, 5);
    if (!is_near)
        return kAway;
    auto const serial = layout.serial();
    PenFields fields {
        .x = u16_le(frame, 1),
        .y = u16_le(frame, 3),
        .pressure = u16_le(frame, 5),
        .in_range = true,
        .tip = has_bit(frame, 0, 0) || has_bit(frame, 0, 3),
        .invert = has_bit(frame, 0, 4),
        .buttons = bits(frame, 0, 1, 2),
        .tool_serial = static_cast<std::uint32_t>(u16_le(report, serial))
            | static_cast<std::uint32_t>(u16_le(report, serial + 2)) << 16,
        .tool_type = static_cast<std::uint32_t>(u16_le(report, layout.tool_type())),
    };
    if (layout.has_tilt)
        fields.tilt_deg = Vec2(s8(frame, 7), s8(frame, 8));
    return fields;
}

// Decodes one frame of a Bluetooth report. No value for an empty frame, since a report may be sent
// before it is full.
Fields decode_bluetooth(Report report, BluetoothLayout const& layout, std::size_t index)
{
    constexpr std::uint8_t kBluetoothReport = 0x80;
    if (report.size() < layout.tool_type() + 2 || (u8(report, 0) & 0xFE) != kBluetoothReport)
        return std::nullopt;
    auto const frame = report.subspan(1 + index * layout.frame_bytes, layout.frame_bytes);
    if (!has_bit(frame, 0, 7))
        return std::nullopt;
    return bluetooth_fields(report, frame, layout);
}

constexpr BluetoothLayout kIntuosProBluetooth { .frames = 7, .frame_bytes = 14, .has_tilt = true };
constexpr BluetoothLayout kIntuosBluetooth { .frames = 4, .frame_bytes = 8 };

// Decodes reports of the second Intuos Pro over Bluetooth.
Fields decode_intuos_pro_bluetooth(Report report, FamilyState& state)
{
    return decode_bluetooth(report, kIntuosProBluetooth, state.frame);
}

// Decodes reports of CTL-4100WL and CTL-6100WL over Bluetooth.
Fields decode_intuos_bluetooth(Report report, FamilyState& state)
{
    return decode_bluetooth(report, kIntuosBluetooth, state.frame);
}

// Skips one leading byte, then decodes the report with `decode`.
template<auto decode> Fields after_one_byte(Report report, FamilyState& state)
{
    return report.empty() ? std::nullopt : decode(report.subspan(1), state);
}

// Pressure in counts that some tablets report although nothing presses.
constexpr std::int32_t kIntuosProTouchAbove = 10;

constexpr PenFamily kWacomFamilies[] = {
    { .name = "wacom-graphire", .decode = decode_graphire, .has_eraser = true },
    { .name = "wacom-graphire-bluetooth", .decode = decode_graphire_bluetooth, .has_eraser = true },
    { .name = "wacom-bamboo-pad",
      .decode = decode_bamboo_pad,
      .has_eraser = true,
      .button_count = 1 },
    { .name = "wacom-intuos", .decode = decode_intuos, .has_eraser = true },
    { .name = "wacom-intuos-pro",
      .decode = decode_intuos_pro,
      .has_tilt = true,
      .has_eraser = true,
      .touch_above = kIntuosProTouchAbove },
    { .name = "wacom-intuos-v2", .decode = decode_intuos_v2, .has_tilt = true, .has_eraser = true },
    { .name = "wacom-intuos-v3",
      .decode = decode_intuos_v3,
      .has_tilt = true,
      .has_eraser = true,
      .button_count = 3 },
    { .name = "wacom-intuos-pro-bluetooth",
      .decode = decode_intuos_pro_bluetooth,
      .has_tilt = true,
      .has_eraser = true,
      .frames = kIntuosProBluetooth.frames,
      .frame_interval = 5ms }, // Equals 200 samples a second.
    { .name = "wacom-intuos-bluetooth",
      .decode = decode_intuos_bluetooth,
      .has_eraser = true,
      .frames = kIntuosBluetooth.frames,
      .frame_interval = 7500us }, // Equals 133 samples a second.
    { .name = "wacom-dtu", .decode = decode_dtu, .has_eraser = true },
    { .name = "wacom-dtus",
      .decode = decode_dtus,
      .has_eraser = true,
      .touch_above = kIntuosProTouchAbove },
    { .name = "wacom-pl", .decode = decode_pl, .has_eraser = true },
    { .name = "wacom-driver-intuos", .decode = after_one_byte<decode_intuos>, .has_eraser = true },
    { .name = "wacom-driver-intuos-pro",
      .decode = after_one_byte<decode_intuos_pro>,
      .has_tilt = true,
      .has_eraser = true,
      .touch_above = kIntuosProTouchAbove },
    { .name = "wacom-driver-intuos-v2",
      .decode = after_one_byte<decode_intuos_v2>,
      .has_tilt = true,
      .has_eraser = true },
};

} // namespace

std::span<PenFamily const> wacom_families()
{
    return kWacomFamilies;
}

} // namespace tractus::drivers
