#include "drivers/pen_decoder.h"

#include "drivers/pen_layout.h"

#include <algorithm>
#include <bitset>
#include <fmt/core.h>
#include <vector>

namespace tractus {

namespace {

constexpr HidUsage kVendorPages = 0xFF00'0000;

bool is_set(std::optional<HidField> const& field, std::span<std::byte const> report)
{
    return field && read_field(*field, report) != 0;
}

std::int32_t read_i32(HidField const& field, std::span<std::byte const> report)
{
    return static_cast<std::int32_t>(read_field(field, report));
}

bool is_null(HidField const& field, std::int32_t value)
{
    return field.has_null_state && (value < field.logical_minimum || value > field.logical_maximum);
}

PenTraits describe(std::vector<PenLayout> const& layouts)
{
    PenTraits traits;
    for (auto const& layout : layouts) {
        traits.size_mm = traits.size_mm.cwiseMax(layout.size_mm);
        traits.is_size_assumed |= layout.size_source == PenLayout::Size::Assumed;
        traits.has_pressure |= layout.pressure.has_value();
        traits.has_tilt |= layout.tilt_x.has_value();
        traits.has_in_range |= layout.in_range.has_value();
        traits.has_eraser |= layout.eraser || layout.invert;
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
    return traits;
}

// Decodes what the report descriptor describes.
class HidPenDecoder final : public PenDecoder {
public:
    HidPenDecoder(HidReportDescriptor const& descriptor, std::vector<PenLayout> layouts)
        : layouts_(std::move(layouts))
        , traits_(describe(layouts_))
    {
        for (auto const& report : descriptor.reports)
            if (report.kind == HidReportKind::Input)
                is_described_.set(report.report_id);
    }

    using PenDecoder::decode;
    PenTraits const& traits() const override { return traits_; }
    Result<std::optional<PenSample>> decode(Timestamp received,
                                            std::span<std::byte const> report) override;

private:
    Result<PenLayout const*> layout_of(std::span<std::byte const> report) const;
    std::optional<PenSample> leave(Timestamp);

    std::vector<PenLayout> layouts_;
    PenTraits traits_;
    std::bitset<256> is_described_; // By report id: those of touches, pads and batteries, too.
    PenSample last_;
    bool has_position_ = false;
};

// Null for a report that is no pen's. Fails if it is not in the descriptor or too short.
Result<PenLayout const*> HidPenDecoder::layout_of(std::span<std::byte const> report) const
{
    if (report.empty())
        return fail(Fault::Device, "an empty report");
    auto const first = std::to_integer<std::uint8_t>(report[0]);
    for (auto const& layout : layouts_) {
        if (layout.report_id != 0 && layout.report_id != first)
            continue;
        if (report.size() < layout.bytes_needed)
            return fail(Fault::Device,
                        fmt::format("pen report {}: {} bytes, expected {}", layout.report_id,
                                    report.size(), layout.report_size));
        return &layout;
    }
    if (!is_described_[first])
        return fail(Fault::Device, fmt::format("report {} is not in the report descriptor", first));
    return nullptr;
}

std::optional<PenSample> HidPenDecoder::leave(Timestamp received)
{
    if (!last_.in_range)
        return std::nullopt;
    last_.time = received;
    last_.in_range = false;
    last_.touching = false;
    last_.buttons = 0;
    last_.raw_pressure = 0;
    if (last_.pressure)
        last_.pressure = 0;
    return last_;
}

// Y and the tilt along it turn round: reports count from the far edge, the tablet frame from the
// near one.
void place(PenSample& sample, PenLayout const& layout, std::int32_t x, std::int32_t y)
{
    sample.raw_x = x;
    sample.raw_y = y;
    sample.position_mm
        = { static_cast<double>(x - layout.x.logical_minimum) * layout.mm_per_count.x(),
            static_cast<double>(layout.y.logical_maximum - y) * layout.mm_per_count.y() };
}

void read_pressure(PenSample& sample, PenLayout const& layout, std::span<std::byte const> report)
{
    if (!layout.pressure)
        return;
    auto const& field = *layout.pressure;
    sample.raw_pressure = read_i32(field, report);
    auto const range = static_cast<double>(field.logical_maximum - field.logical_minimum);
    auto const above = static_cast<double>(sample.raw_pressure - field.logical_minimum);
    sample.pressure = std::clamp(above / range, 0.0, 1.0);
}

void read_tilt(PenSample& sample, PenLayout const& layout, std::span<std::byte const> report)
{
    if (!layout.tilt_x || !layout.tilt_y)
        return;
    auto const& scale = layout.tilt_rad_per_count;
    sample.tilt_rad = Vec2(static_cast<double>(read_field(*layout.tilt_x, report)) * scale.x(),
                           static_cast<double>(-read_field(*layout.tilt_y, report)) * scale.y());
}

Result<std::optional<PenSample>> HidPenDecoder::decode(Timestamp received,
                                                       std::span<std::byte const> report)
{
    auto const* const layout = TRY(layout_of(report));
    if (!layout)
        return std::nullopt;

    PenSample sample { .time = received,
                       .position_mm = last_.position_mm,
                       .raw_x = last_.raw_x,
                       .raw_y = last_.raw_y };
    read_pressure(sample, *layout, report);
    bool const erases = is_set(layout->eraser, report);
    bool const tip = layout->tip ? is_set(layout->tip, report)
                                 : sample.raw_pressure > layout->pressure->logical_minimum;
    sample.touching = tip || erases;
    sample.eraser = erases || is_set(layout->invert, report);
    sample.in_range = sample.touching || !layout->in_range || is_set(layout->in_range, report);
    if (!sample.in_range || (last_.in_range && sample.eraser != last_.eraser))
        return leave(received);

    auto const x = read_i32(layout->x, report);
    auto const y = read_i32(layout->y, report);
    bool const has_place = !is_null(layout->x, x) && !is_null(layout->y, y);
    if (!has_place && !has_position_)
        return std::nullopt;
    if (has_place)
        place(sample, *layout, x, y);
    has_position_ = true;
    read_tilt(sample, *layout, report);
    for (unsigned i = 0; i < layout->buttons.size(); ++i)
        if (is_set(layout->buttons[i], report))
            sample.buttons |= 1u << i;
    last_ = sample;
    return std::optional(sample);
}

// Why a descriptor gives no layout, for a person to read.
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

Result<std::unique_ptr<PenDecoder>> make_pen_decoder(DeviceInfo const& info)
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
    return std::make_unique<HidPenDecoder>(*descriptor, std::move(layouts));
}

} // namespace tractus
