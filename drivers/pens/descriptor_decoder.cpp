#include "drivers/pens/descriptor_decoder.h"

#include "drivers/pens/known_habits.h"
#include "drivers/pens/pen_state.h"
#include "drivers/reports/pen_layout.h"
#include "drivers/reports/report_bytes.h"

#include <algorithm>
#include <bitset>
#include <fmt/core.h>
#include <vector>

namespace tractus::drivers {

namespace {

constexpr HidUsage kVendorPages = 0xFF00'0000;

bool is_set(std::optional<HidField> const& field, std::span<std::byte const> report)
{
    if (!field)
        return false;
    // Fast path: most switches are one bit. The report has enough bytes (PenLayout::bytes_needed).
    if (field->bit_size == 1)
        return has_bit(report, field->bit_offset / 8, field->bit_offset % 8);
    return read_field(*field, report) != 0;
}

std::int32_t read_i32(HidField const& field, std::span<std::byte const> report)
{
    return static_cast<std::int32_t>(read_field(field, report));
}

bool is_null(HidField const& field, std::int32_t value)
{
    return field.has_null_state && (value < field.logical_minimum || value > field.logical_maximum);
}

PenTraits describe(std::vector<PenLayout> const& layouts, PenHabits const& habits)
{
    PenTraits traits;
    for (auto const& layout : layouts) {
        traits.size_mm = traits.size_mm.cwiseMax(layout.size_mm);
        traits.is_size_assumed |= layout.size_source == PenLayout::Size::Assumed;
        traits.has_pressure |= layout.pressure.has_value();
        traits.has_tilt |= layout.tilt_x.has_value();
        traits.has_in_range |= layout.in_range.has_value();
        traits.has_eraser |= layout.invert || (layout.eraser && !habits.second_button_is_eraser);
        auto const buttons = std::count_if(layout.buttons.begin(), layout.buttons.end(),
                                           [](auto const& button) { return button.has_value(); });
        traits.button_count = std::max(traits.button_count, static_cast<unsigned>(buttons));
        auto const raise = [](std::int32_t& maximum, HidField const& field) {
            maximum = std::max(maximum, static_cast<std::int32_t>(field.logical_maximum));
        };
        raise(traits.raw_x_maximum, layout.x);
        raise(traits.raw_y_maximum, layout.y);
        if (layout.pressure)
            raise(traits.raw_pressure_maximum, *layout.pressure);
    }
    if (habits.second_button_is_eraser)
        traits.button_count = std::max(traits.button_count, 2u);
    if (habits.third_button_is_invert)
        traits.button_count = std::max(traits.button_count, 3u);
    return traits;
}

// A kind of pen report that the descriptor declares, with the factors to decode it.
struct DescribedPen {
    PenLayout layout;
    PenScale scale;
    Vec2 tilt_deg_per_count = Vec2::Zero();
};

DescribedPen describe_pen(PenLayout const& layout)
{
    PenScale scale { .x_minimum = static_cast<std::int32_t>(layout.x.logical_minimum),
                     .y_maximum = static_cast<std::int32_t>(layout.y.logical_maximum),
                     .mm_per_count = layout.mm_per_count,
                     .has_tilt = layout.tilt_x.has_value() };
    if (layout.pressure) {
        scale.has_pressure = true;
        scale.pressure_minimum = static_cast<std::int32_t>(layout.pressure->logical_minimum);
        scale.pressure_maximum = static_cast<std::int32_t>(layout.pressure->logical_maximum);
        scale.touch_above = scale.pressure_minimum;
    }
    auto const& tilt = layout.tilt_rad_per_count;
    return { layout, scale, { degrees(tilt.x()), degrees(tilt.y()) } };
}

PenFields read_fields(DescribedPen const& pen, std::span<std::byte const> report)
{
    auto const& layout = pen.layout;
    PenFields fields { .x = read_i32(layout.x, report),
                       .y = read_i32(layout.y, report),
                       .invert = is_set(layout.invert, report),
                       .eraser_touch = is_set(layout.eraser, report) };
    fields.carries_position = !is_null(layout.x, fields.x) && !is_null(layout.y, fields.y);
    if (layout.tip)
        fields.tip = is_set(layout.tip, report);
    if (layout.in_range)
        fields.in_range = is_set(layout.in_range, report);
    if (layout.pressure)
        fields.pressure = read_i32(*layout.pressure, report);
    if (layout.tilt_x && layout.tilt_y)
        fields.tilt_deg = {
            static_cast<double>(read_field(*layout.tilt_x, report)) * pen.tilt_deg_per_count.x(),
            static_cast<double>(read_field(*layout.tilt_y, report)) * pen.tilt_deg_per_count.y(),
        };
    for (unsigned i = 0; i < layout.buttons.size(); ++i)
        if (is_set(layout.buttons[i], report))
            fields.buttons |= 1u << i;
    if (layout.tool_serial)
        fields.tool_serial = static_cast<std::uint32_t>(read_field(*layout.tool_serial, report));
    if (layout.tool_type)
        fields.tool_type = static_cast<std::uint32_t>(read_field(*layout.tool_type, report));
    return fields;
}

// Returns which buttons occur in the pens' reports; layouts without an in-range field are mice and
// do not count.
PenButtons buttons_of(std::vector<PenLayout> const& layouts)
{
    PenButtons buttons;
    for (auto const& layout : layouts) {
        if (!layout.in_range)
            continue;
        buttons.has_second |= layout.buttons[1].has_value();
        buttons.has_second_by_name |= layout.has_second_barrel_switch();
        buttons.has_second_as_tip |= layout.has_secondary_tip_switch();
        buttons.has_eraser |= layout.eraser.has_value();
        buttons.has_invert |= layout.invert.has_value();
    }
    return buttons;
}

// Decodes pen reports by the report descriptor.
class HidPenDecoder final : public PenDecoder {
public:
    HidPenDecoder(HidReportDescriptor const& descriptor, std::vector<PenLayout> const& layouts,
                  PenHabits const& habits)
        : traits_(describe(layouts, habits))
        , state_(habits)
    {
        for (auto const& layout : layouts)
            pens_.push_back(describe_pen(layout));
        for (auto const& report : descriptor.reports)
            if (report.kind == HidReportKind::Input)
                is_described_.set(report.report_id);
    }

    using PenDecoder::decode;
    PenTraits const& traits() const override { return traits_; }
    Result<void> decode(Timestamp received, std::span<std::byte const> report,
                        std::vector<PenSample>& out) override;
    std::optional<Duration> silence_limit() const override { return state_.silence_limit(); }
    std::optional<PenSample> leave(Timestamp time) override { return state_.leave(time); }

private:
    Result<DescribedPen const*> pen_of(std::span<std::byte const> report) const;

    std::vector<DescribedPen> pens_; // One entry for each report id that carries pen data.
    PenTraits traits_;
    // True for each report id that the descriptor declares, including those of touches, pads and
    // batteries.
    std::bitset<256> is_described_;
    PenState state_;
};

// Returns the pen that a report describes; null if the report is not about a pen. Fails if the
// report's id is not in the descriptor or the report is too short.
Result<DescribedPen const*> HidPenDecoder::pen_of(std::span<std::byte const> report) const
{
    if (report.empty())
        return fail(Fault::Device, "an empty report");
    auto const first = std::to_integer<std::uint8_t>(report[0]);
    for (auto const& pen : pens_) {
        auto const& layout = pen.layout;
        if (layout.report_id != 0 && layout.report_id != first)
            continue;
        if (report.size() < layout.bytes_needed)
            return fail(Fault::Device,
                        fmt::format("pen report {}: {} bytes, expected {}", layout.report_id,
                                    report.size(), layout.report_size));
        return &pen;
    }
    if (!is_described_[first])
        return fail(Fault::Device, fmt::format("report {} is not in the report descriptor", first));
    return nullptr;
}

Result<void> HidPenDecoder::decode(Timestamp received, std::span<std::byte const> report,
                                   std::vector<PenSample>& out)
{
    auto const* const pen = TRY(pen_of(report));
    if (!pen)
        return {};
    if (auto const sample = state_.push(received, read_fields(*pen, report), pen->scale))
        out.push_back(*sample);
    return {};
}

// Explains to the user why a descriptor describes no usable pen.
std::string explain_no_pen(DeviceInfo const& info, HidReportDescriptor const& descriptor)
{
    bool const is_vendor
        = std::any_of(descriptor.fields.begin(), descriptor.fields.end(), [](auto const& field) {
              return field.kind == HidReportKind::Input && field.usage >= kVendorPages;
          });
    return fmt::format(
        "{} ({:04x}:{:04x}) is not a pen that describes itself: its report descriptor has {}",
        info.name.empty() ? "the device" : info.name, info.vendor_id, info.product_id,
        is_vendor ? "reports in its maker's own format, and no X, Y and tip of a pen"
                  : "no X, Y and tip of a pen");
}

} // namespace

Result<std::unique_ptr<PenDecoder>> make_descriptor_decoder(DeviceInfo const& info,
                                                            std::optional<Vec2> const& size_mm,
                                                            std::optional<double> width_to_height)
{
    auto descriptor = parse_report_descriptor(info.report_descriptor);
    if (!descriptor)
        return fail(descriptor.error().fault,
                    fmt::format("{} ({:04x}:{:04x}): {}",
                                info.name.empty() ? "the device" : info.name, info.vendor_id,
                                info.product_id, descriptor.error().message));
    auto layouts = find_pen_layouts(*descriptor);
    if (layouts.empty())
        return fail(Fault::User, explain_no_pen(info, *descriptor));
    for (auto& layout : layouts) {
        if (width_to_height && layout.has_square_counts())
            layout.take_proportions(*width_to_height);
        if (auto const& known_mm = size_mm ? size_mm : info.size_mm)
            layout.take_known_size(*known_mm);
    }
    auto const habits = known_habits(info.vendor_id, info.product_id, buttons_of(layouts));
    return std::make_unique<HidPenDecoder>(*descriptor, layouts, habits);
}

} // namespace tractus::drivers
