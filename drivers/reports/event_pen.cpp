#include "drivers/reports/event_pen.h"

#include "engine/base/check.h"
#include "engine/base/vectors.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>
#include <linux/input-event-codes.h>
#include <optional>
#include <utility>

namespace tractus::drivers {

namespace {

constexpr std::string_view kEventPath = "evdev:";
constexpr std::byte kEventPenReport { 1 }; // Report id of all reports made by EventPen.

// Tools that draw. A puck is not one of them.
constexpr std::array<std::uint16_t, 4> kDrawingTools { BTN_TOOL_PEN, BTN_TOOL_BRUSH,
                                                       BTN_TOOL_PENCIL, BTN_TOOL_AIRBRUSH };

// A switch in the report. `bit` is its position in the first byte after the report id.
struct PenSwitch {
    unsigned bit;
    std::uint16_t usage_page;
    std::uint16_t usage;
};
constexpr unsigned kTipBit = 0, kFirstButtonBit = 1, kEraserTouchBit = 4, kInvertBit = 5,
                   kInRangeBit = 6;
constexpr std::array<PenSwitch, 7> kPenSwitches { {
    { kTipBit, 0x0D, 0x42 },
    { kFirstButtonBit, 0x0D, 0x44 },     // HID usage Barrel Switch.
    { kFirstButtonBit + 1, 0x0D, 0x5A }, // HID usage Secondary Barrel Switch.
    { kFirstButtonBit + 2, 0xFF0D,
      0x5D }, // Wacom's usage for a third barrel switch; the usage tables have none.
    { kEraserTouchBit, 0x0D, 0x45 },
    { kInvertBit, 0x0D, 0x3C },
    { kInRangeBit, 0x0D, 0x32 },
} };
constexpr std::array<std::uint16_t, 3> kPenButtons { BTN_STYLUS, BTN_STYLUS2, BTN_STYLUS3 };

// A 32-bit number in the report. kPenNumbers lists the numbers in the report's order.
struct PenNumber {
    std::uint16_t code;
    std::uint8_t usage_page;
    std::uint8_t usage;
};
constexpr std::array<PenNumber, 5> kPenNumbers { {
    { ABS_X, 0x01, 0x30 },
    { ABS_Y, 0x01, 0x31 },
    { ABS_PRESSURE, 0x0D, 0x30 },
    { ABS_TILT_X, 0x0D, 0x3D },
    { ABS_TILT_Y, 0x0D, 0x3E },
} };

bool is_wide(EventAbilities const& abilities, std::uint16_t code)
{
    auto const axis = abilities.axes.find(code);
    // On some tablets the pad keys report a position with a range of one count. Such devices are
    // not pens.
    return axis != abilities.axes.end()
        && std::int64_t { axis->second.maximum } - axis->second.minimum > 1;
}

bool has_drawing_tool(EventAbilities const& abilities)
{
    return std::any_of(kDrawingTools.begin(), kDrawingTools.end(),
                       [&](std::uint16_t tool) { return abilities.keys.contains(tool); });
}

// Writes the items of a report descriptor (HID 1.11 section 6.2.2).
class DescriptorWriter {
public:
    // Writes an item with the fewest bytes that hold the value as a signed number.
    void item(std::uint8_t prefix, std::int64_t value)
    {
        std::size_t const size = value == static_cast<std::int8_t>(value) ? 1
            : value == static_cast<std::int16_t>(value)                   ? 2
                                                                          : 4;
        put(static_cast<std::uint8_t>(prefix | (size == 4 ? 3 : size)));
        for (std::size_t i = 0; i < size; ++i)
            put(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i)));
    }
    void put(std::uint8_t byte) { bytes_.push_back(static_cast<std::byte>(byte)); }
    std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
};

constexpr std::uint8_t kUsagePageItem = 0x04, kUsageItem = 0x08, kLogicalMinimumItem = 0x14,
                       kLogicalMaximumItem = 0x24, kPhysicalMinimumItem = 0x34,
                       kPhysicalMaximumItem = 0x44, kUnitExponentItem = 0x54, kUnitItem = 0x64,
                       kReportSizeItem = 0x74, kReportIdItem = 0x84, kReportCountItem = 0x94,
                       kInputItem = 0x80, kCollectionItem = 0xA0, kEndCollection = 0xC0;

// A physical range and its unit, as HID descriptors declare them.
struct PhysicalRange {
    std::int64_t minimum = 0;
    std::int64_t maximum = 0;
    std::int64_t unit = 0;
    std::int64_t exponent = 0;
};

// Returns an axis's physical range in micrometres or, for a tilt, in thousandths of a degree; all
// members are 0 if the resolution is not known.
PhysicalRange physical_range(std::uint16_t code, EventAxis const& axis)
{
    constexpr std::int64_t kCentimetres = 0x11, kDegrees = 0x14;
    bool const is_tilt = code == ABS_TILT_X || code == ABS_TILT_Y;
    if (axis.resolution <= 0 || code == ABS_PRESSURE)
        return {};
    double const steps = (is_tilt ? degrees(1.0) * 1000 : 1000.0) / axis.resolution;
    auto const scaled = [&](std::int64_t counts) {
        constexpr auto kMax = static_cast<double>(std::numeric_limits<std::int32_t>::max());
        return std::llround(std::clamp(static_cast<double>(counts) * steps, -kMax, kMax));
    };
    if (is_tilt)
        return { scaled(axis.minimum), scaled(axis.maximum), kDegrees, -3 };
    return { 0, scaled(std::int64_t { axis.maximum } - axis.minimum), kCentimetres, -4 };
}

void write_switches(DescriptorWriter& out, EventAbilities const& abilities)
{
    constexpr std::int64_t kData = 0x02, kConstant = 0x03;
    out.item(kLogicalMinimumItem, 0);
    out.item(kLogicalMaximumItem, 1);
    out.item(kReportSizeItem, 1);
    out.item(kReportCountItem, 1);
    bool const tells_touch = abilities.keys.contains(BTN_TOUCH);
    for (auto const& [bit, page, usage] : kPenSwitches) {
        bool const is_told = (bit == kTipBit || bit == kEraserTouchBit) ? tells_touch
            : (bit == kInRangeBit || bit == kInvertBit)
            ? has_drawing_tool(abilities)
            : abilities.keys.contains(kPenButtons[bit - kFirstButtonBit]);
        if (is_told) {
            out.put(kUsagePageItem | 2);
            out.put(static_cast<std::uint8_t>(page & 0xff));
            out.put(static_cast<std::uint8_t>(page >> 8));
            out.item(kUsageItem, usage);
        }
        out.item(kInputItem, is_told ? kData : kConstant);
    }
    out.item(kInputItem, kConstant); // Pads the switches to eight bits.
}

} // namespace

bool is_event_pen(EventAbilities const& abilities)
{
    bool const has_stylus = has_drawing_tool(abilities) || abilities.keys.contains(BTN_STYLUS);
    bool const can_touch
        = abilities.keys.contains(BTN_TOUCH) || abilities.axes.contains(ABS_PRESSURE);
    return has_stylus && can_touch && is_wide(abilities, ABS_X) && is_wide(abilities, ABS_Y);
}

std::vector<std::byte> describe_event_pen(EventAbilities const& abilities)
{
    constexpr std::int64_t kDigitizerPage = 0x0D, kPen = 0x02, kStylus = 0x20;
    constexpr std::int64_t kApplication = 1, kPhysical = 0, kData = 0x02, kNumberBits = 32;
    DescriptorWriter out;
    out.item(kUsagePageItem, kDigitizerPage);
    out.item(kUsageItem, kPen);
    out.item(kCollectionItem, kApplication);
    out.item(kReportIdItem, std::to_integer<std::int64_t>(kEventPenReport));
    out.item(kUsageItem, kStylus);
    out.item(kCollectionItem, kPhysical);
    write_switches(out, abilities);
    out.item(kReportSizeItem, kNumberBits);
    for (auto const& [code, page, usage] : kPenNumbers) {
        auto const axis = abilities.axes.find(code);
        if (axis == abilities.axes.end())
            continue;
        auto const range = physical_range(code, axis->second);
        out.item(kUsagePageItem, page);
        out.item(kUsageItem, usage);
        out.item(kLogicalMinimumItem, axis->second.minimum);
        out.item(kLogicalMaximumItem, axis->second.maximum);
        out.item(kPhysicalMinimumItem, range.minimum);
        out.item(kPhysicalMaximumItem, range.maximum);
        out.item(kUnitExponentItem, range.exponent & 0x0f);
        out.item(kUnitItem, range.unit);
        out.item(kInputItem, kData);
    }
    out.put(kEndCollection);
    out.put(kEndCollection);
    return out.take();
}

struct EventPen::State {
    explicit State(EventAbilities its)
        : abilities(std::move(its))
    {
    }

    bool take(std::uint16_t type, std::uint16_t code, std::int32_t value);
    std::span<std::byte const> write_report();

    EventAbilities abilities;
    std::set<std::uint16_t> pressed {}; // Codes of the keys that are pressed.
    std::array<std::int32_t, kPenNumbers.size()> numbers {};
    std::bitset<kPenNumbers.size()> known {}; // For each number, whether it has been received.
    bool has_news = false;
    bool has_dropped = false;
    std::vector<std::byte> report {};
};

// Handles one event. Returns false if it is not about the pen.
bool EventPen::State::take(std::uint16_t type, std::uint16_t code, std::int32_t value)
{
    if (type == EV_ABS) {
        auto const number = std::ranges::find(kPenNumbers, code, &PenNumber::code);
        if (number == kPenNumbers.end())
            return false;
        auto const index = static_cast<std::size_t>(number - kPenNumbers.begin());
        numbers[index] = value;
        known.set(index);
        return true;
    }
    bool const is_pens = code == BTN_TOUCH || code == BTN_TOOL_RUBBER
        || std::ranges::find(kDrawingTools, code) != kDrawingTools.end()
        || std::ranges::find(kPenButtons, code) != kPenButtons.end();
    if (type != EV_KEY || !is_pens)
        return false;
    if (value != 0)
        pressed.insert(code);
    else
        pressed.erase(code);
    return true;
}

std::span<std::byte const> EventPen::State::write_report()
{
    bool const is_rubber = pressed.contains(BTN_TOOL_RUBBER);
    bool const is_there = is_rubber
        || std::ranges::any_of(kDrawingTools, [&](auto tool) { return pressed.contains(tool); });
    bool const touches = pressed.contains(BTN_TOUCH);
    unsigned switches = 0;
    auto const set = [&](unsigned bit, bool is_on) { switches |= is_on ? 1u << bit : 0u; };
    set(kTipBit, touches && !is_rubber);
    set(kEraserTouchBit, touches && is_rubber);
    set(kInvertBit, is_rubber);
    set(kInRangeBit, is_there);
    for (unsigned i = 0; i < kPenButtons.size(); ++i)
        set(kFirstButtonBit + i, pressed.contains(kPenButtons[i]));
    report = { kEventPenReport, static_cast<std::byte>(switches) };
    for (std::size_t i = 0; i < kPenNumbers.size(); ++i)
        if (abilities.axes.contains(kPenNumbers[i].code))
            for (unsigned shift = 0; shift < 32; shift += 8)
                report.push_back(
                    static_cast<std::byte>(static_cast<std::uint32_t>(numbers[i]) >> shift & 0xff));
    return report;
}

EventPen::EventPen(EventAbilities abilities)
    : state_(std::make_unique<State>(std::move(abilities)))
{
    CHECK(is_event_pen(state_->abilities));
}

EventPen::~EventPen() = default;
EventPen::EventPen(EventPen&&) noexcept = default;
EventPen& EventPen::operator=(EventPen&&) noexcept = default;

std::span<std::byte const> EventPen::push(std::uint16_t type, std::uint16_t code,
                                          std::int32_t value)
{
    auto& state = *state_;
    if (type != EV_SYN) {
        if (!state.has_dropped && state.take(type, code, value))
            state.has_news = true;
        return {};
    }
    if (code == SYN_DROPPED)
        state.has_dropped = true;
    if (code != SYN_REPORT || std::exchange(state.has_dropped, false)
        || !std::exchange(state.has_news, false))
        return {};
    bool const has_place
        = state.known[0] && state.known[1]; // ABS_X and ABS_Y are the first two numbers.
    return has_place ? state.write_report() : std::span<std::byte const>();
}

std::string event_pen_path(std::string_view kernel_path)
{
    return std::string(kEventPath) + std::string(kernel_path);
}

bool has_event_pen_reports(DeviceInfo const& info)
{
    return info.physical_path.starts_with(kEventPath);
}

} // namespace tractus::drivers
