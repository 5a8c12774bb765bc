#include "drivers/reports/pen_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tractus::drivers {

namespace {

// Usages of HID Usage Tables 1.4: Generic Desktop (page 0x01), Button (0x09), Digitizers (0x0D).
constexpr HidUsage kPointer = 0x0001'0001;
constexpr HidUsage kMouse = 0x0001'0002;
constexpr HidUsage kX = 0x0001'0030;
constexpr HidUsage kY = 0x0001'0031;
constexpr HidUsage kButton1 = 0x0009'0001;
constexpr HidUsage kDigitizer = 0x000D'0001;
constexpr HidUsage kPen = 0x000D'0002;
constexpr HidUsage kLightPen = 0x000D'0003;
constexpr HidUsage kTouchScreen = 0x000D'0004;
constexpr HidUsage kMultiplePointDigitizer = 0x000D'000C;
constexpr HidUsage kStylus = 0x000D'0020;
constexpr HidUsage kPuck = 0x000D'0021;
constexpr HidUsage kFinger = 0x000D'0022;
constexpr HidUsage kTipPressure = 0x000D'0030;
constexpr HidUsage kInRange = 0x000D'0032;
constexpr HidUsage kInvert = 0x000D'003C;
constexpr HidUsage kTiltX = 0x000D'003D;
constexpr HidUsage kTiltY = 0x000D'003E;
constexpr HidUsage kTipSwitch = 0x000D'0042;
constexpr HidUsage kSecondaryTipSwitch = 0x000D'0043;
constexpr HidUsage kBarrelSwitch = 0x000D'0044;
constexpr HidUsage kEraser = 0x000D'0045;
constexpr HidUsage kTabletPick = 0x000D'0046;
constexpr HidUsage kSecondaryBarrelSwitch = 0x000D'005A;
constexpr HidUsage kTransducerSerialNumber = 0x000D'005B;
// Wacom's own usage, since the usage tables define none for a third barrel switch.
constexpr HidUsage kWacomThirdBarrelSwitch = 0xFF0D'005D;
constexpr HidUsage kWacomToolType = 0xFF0D'0077;

constexpr double kMinSide_mm = 20;
constexpr double kMaxSide_mm = 800;
constexpr double kMaxCountsPerMm = 1000;

constexpr double kUsualProportions = 16.0 / 10;

enum class Tool { None, Pen, Mouse };

// Maps a usage of Wacom's page 0xFF0D to the standard one. Wacom's page has the usage numbers of
// the Digitizers page, and from 0x100 on those of the Generic Desktop page.
HidUsage standard_usage(HidUsage usage)
{
    constexpr HidUsage kWacomDigitizer = 0xFF0D, kDigitizers = 0x000D, kGenericDesktop = 0x0001;
    if (usage >> 16 != kWacomDigitizer || usage == kWacomThirdBarrelSwitch
        || usage == kWacomToolType)
        return usage;
    switch ((usage >> 8) & 0xFF) {
    case 0:
        return kDigitizers << 16 | (usage & 0xFF);
    case 1:
        return kGenericDesktop << 16 | (usage & 0xFF);
    default:
        return usage;
    }
}

// Returns the kind of tool that a collection's fields belong to: the innermost collection that
// names a tool decides, since a pen's collection may lie within a touch screen's, and vice versa.
Tool tool_of(HidReportDescriptor const& descriptor, std::optional<std::size_t> collection)
{
    while (collection) {
        auto const& [usage, type, parent] = descriptor.collections[*collection];
        switch (auto const known = standard_usage(usage); known) {
        case kPen:
        case kStylus:
        case kLightPen:
        case kDigitizer:
            return Tool::Pen;
        case kTouchScreen:
        case kMultiplePointDigitizer:
        case kFinger:
        case kPuck:
            return Tool::None;
        case kPointer:
        case kMouse:
            return Tool::Mouse;
        default:
            if (known > kLightPen
                && known < kStylus) // Touch pads, whiteboards and other digitizers.
                return Tool::None;
            break;
        }
        collection = parent;
    }
    return Tool::None;
}

// A layout being assembled from a report's fields.
struct Draft {
    std::uint8_t report_id = 0;
    Tool tool = Tool::None;
    std::optional<HidField> x {};
    std::optional<HidField> y {};
    std::optional<HidField> tablet_pick {};   // The second barrel button on some devices.
    std::optional<HidField> secondary_tip {}; // The second barrel button on other devices.
    PenLayout layout {};
};

// Returns the member of the draft that a usage belongs to; null for usages that are not about a
// pen.
std::optional<HidField>* slot(Draft& draft, HidUsage usage)
{
    auto& layout = draft.layout;
    bool const is_mouse = draft.tool == Tool::Mouse;
    switch (standard_usage(usage)) {
    case kX:
        return &draft.x;
    case kY:
        return &draft.y;
    case kTipPressure:
        return &layout.pressure;
    case kInRange:
        return &layout.in_range;
    case kInvert:
        return &layout.invert;
    case kEraser:
        return &layout.eraser;
    case kTipSwitch:
        return &layout.tip;
    case kBarrelSwitch:
        return &layout.buttons[0];
    case kSecondaryBarrelSwitch:
        return &layout.buttons[1];
    case kWacomThirdBarrelSwitch:
        return &layout.buttons[2];
    case kTransducerSerialNumber:
        return &layout.tool_serial;
    case kWacomToolType:
        return &layout.tool_type;
    case kTabletPick:
        return &draft.tablet_pick;
    case kSecondaryTipSwitch:
        return &draft.secondary_tip;
    case kTiltX:
        return &layout.tilt_x;
    case kTiltY:
        return &layout.tilt_y;
    case kButton1:
        return is_mouse ? &layout.tip : nullptr;
    case kButton1 + 1:
        return is_mouse ? &layout.buttons[0] : nullptr;
    case kButton1 + 2:
        return is_mouse ? &layout.buttons[1] : nullptr;
    default:
        return nullptr;
    }
}

bool is_usable(HidField const& field)
{
    if (field.kind != HidReportKind::Input || field.is_array || field.is_relative
        || field.bit_size > 32)
        return false;
    auto const usage = standard_usage(field.usage);
    if (usage == kTransducerSerialNumber
        || usage == kWacomToolType) // Serial numbers and tool types have no logical range.
        return true;
    return field.logical_maximum > field.logical_minimum
        && field.logical_maximum <= std::numeric_limits<std::int32_t>::max();
}

std::vector<Draft> collect_drafts(HidReportDescriptor const& descriptor)
{
    std::vector<Draft> drafts;
    for (auto const& field : descriptor.fields) {
        if (!is_usable(field))
            continue;
        auto const tool = tool_of(descriptor, field.collection);
        if (tool == Tool::None)
            continue;
        auto draft = std::find_if(drafts.begin(), drafts.end(), [&](Draft const& d) {
            return d.report_id == field.report_id && d.tool == tool;
        });
        if (draft == drafts.end())
            draft = drafts.insert(draft, { .report_id = field.report_id, .tool = tool });
        // The first field of a usage is used: many descriptors repeat the last usage as padding.
        if (auto* const member = slot(*draft, field.usage); member && !*member)
            *member = field;
    }
    return drafts;
}

double counts(HidField const& field)
{
    return static_cast<double>(field.logical_maximum - field.logical_minimum);
}

bool is_plausible(HidField const& field, std::optional<double> side_mm)
{
    return side_mm && *side_mm >= kMinSide_mm && *side_mm <= kMaxSide_mm
        && counts(field) / *side_mm <= kMaxCountsPerMm;
}

// Returns the physical length of a field without a unit. It is read as thousandths of an inch, for
// which some makers omit the unit.
std::optional<double> span_without_unit_mm(HidField const& field)
{
    auto const span = field.physical_maximum - field.physical_minimum;
    if (field.unit != 0 || span <= 0)
        return std::nullopt;
    return static_cast<double>(span) * 0.0254;
}

double assumed_counts_per_mm(double longer_side_counts)
{
    for (double const counts_per_inch : { 5080.0, 2540.0 }) {
        auto const side_mm = longer_side_counts / counts_per_inch * 25.4;
        if (side_mm >= 80 && side_mm <= 500)
            return counts_per_inch / 25.4;
    }
    return longer_side_counts / 250;
}

void set_size(PenLayout& layout, Vec2 const& size_mm, PenLayout::Size source)
{
    layout.size_mm = size_mm;
    layout.size_source = source;
    layout.mm_per_count = size_mm.cwiseQuotient(Vec2(counts(layout.x), counts(layout.y)));
}

void find_size(PenLayout& layout)
{
    using Span = std::optional<double> (*)(HidField const&);
    for (Span const span : { &physical_span_mm, &span_without_unit_mm }) {
        auto const width_mm = span(layout.x);
        auto const height_mm = span(layout.y);
        if (is_plausible(layout.x, width_mm) && is_plausible(layout.y, height_mm)) {
            auto const source
                = span == &physical_span_mm ? PenLayout::Size::Declared : PenLayout::Size::Assumed;
            return set_size(layout, { *width_mm, *height_mm }, source);
        }
    }
    Vec2 const size_counts(counts(layout.x), counts(layout.y));
    Vec2 const size_mm = size_counts / assumed_counts_per_mm(size_counts.maxCoeff());
    set_size(layout, size_mm, PenLayout::Size::Assumed);
    // No tablet is square: axes with equal ranges do not give its proportions.
    if (layout.has_square_counts())
        layout.take_proportions(kUsualProportions);
}

double tilt_scale(HidField const& field)
{
    auto const extent
        = static_cast<double>(std::max(field.logical_maximum, -field.logical_minimum));
    auto const is_angle = [&](double scale) { return extent * scale <= radians(180.0); };
    if (auto const declared = radians_per_count(field); declared && is_angle(*declared))
        return *declared;
    for (double const scale : { radians(1.0), radians(0.01) })
        if (is_angle(scale))
            return scale;
    return kPi / counts(field);
}

std::size_t end_byte(HidField const& field)
{
    return (field.bit_offset + field.bit_size + 7) / 8;
}

void find_bytes_needed(PenLayout& layout)
{
    layout.bytes_needed = std::max(end_byte(layout.x), end_byte(layout.y));
    for (auto const* field :
         { &layout.tip, &layout.pressure, &layout.in_range, &layout.invert, &layout.eraser,
           &layout.buttons[0], &layout.buttons[1], &layout.buttons[2], &layout.tilt_x,
           &layout.tilt_y, &layout.tool_serial, &layout.tool_type })
        if (*field)
            layout.bytes_needed = std::max(layout.bytes_needed, end_byte(**field));
}

std::optional<PenLayout> finish(Draft draft, HidReportDescriptor const& descriptor)
{
    auto& layout = draft.layout;
    if (!draft.x || !draft.y || !(layout.tip || layout.pressure))
        return std::nullopt;
    // Reports of a touch screen or of a virtual machine's mouse have no pressure.
    if (draft.tool == Tool::Mouse && !layout.pressure)
        return std::nullopt;
    layout.report_id = draft.report_id;
    layout.report_size = descriptor.report_size(HidReportKind::Input, draft.report_id);
    layout.x = *draft.x;
    layout.y = *draft.y;
    for (auto const& other : { draft.tablet_pick, draft.secondary_tip })
        if (!layout.buttons[1])
            layout.buttons[1] = other;
    if (!layout.tilt_x || !layout.tilt_y)
        layout.tilt_x = layout.tilt_y = std::nullopt;
    else
        layout.tilt_rad_per_count = { tilt_scale(*layout.tilt_x), tilt_scale(*layout.tilt_y) };
    find_size(layout);
    find_bytes_needed(layout);
    return layout;
}

} // namespace

bool PenLayout::has_square_counts() const
{
    return counts(x) == counts(y);
}

void PenLayout::take_proportions(double width_to_height)
{
    if (size_source == Size::Assumed)
        set_size(*this, { size_mm.x(), size_mm.x() / width_to_height }, Size::Assumed);
}

// True if the two sizes are equal with width and height exchanged, and not nearly square.
static bool is_turned(Vec2 const& a, Vec2 const& b)
{
    auto const is_near = [](double first, double second) {
        return std::abs(first - second) <= 0.03 * std::max(first, second);
    };
    return is_near(a.x(), b.y()) && is_near(a.y(), b.x()) && !is_near(a.x(), a.y());
}

void PenLayout::take_known_size(Vec2 const& known_size_mm)
{
    if (size_source == Size::Assumed || is_turned(size_mm, known_size_mm))
        set_size(*this, known_size_mm, Size::Known);
}

bool PenLayout::has_second_barrel_switch() const
{
    return buttons[1] && standard_usage(buttons[1]->usage) == kSecondaryBarrelSwitch;
}

bool PenLayout::has_secondary_tip_switch() const
{
    return buttons[1] && standard_usage(buttons[1]->usage) == kSecondaryTipSwitch;
}

std::vector<PenLayout> find_pen_layouts(HidReportDescriptor const& descriptor)
{
    std::vector<PenLayout> layouts;
    std::optional<Vec2> pen_size_mm;
    for (auto const& draft : collect_drafts(descriptor)) {
        auto const layout = finish(draft, descriptor);
        if (!layout)
            continue;
        if (draft.tool == Tool::Pen && !pen_size_mm)
            pen_size_mm = layout->size_mm;
        layouts.push_back(*layout);
    }
    // A tablet's mouse reports refer to the same surface as its pen reports, but rarely declare its
    // size.
    for (auto& layout : layouts)
        if (pen_size_mm && !layout.in_range && layout.size_source == PenLayout::Size::Assumed)
            set_size(layout, *pen_size_mm, PenLayout::Size::Assumed);
    return layouts;
}

} // namespace tractus::drivers
