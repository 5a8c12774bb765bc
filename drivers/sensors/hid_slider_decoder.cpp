#include "drivers/sensors/hid_slider_decoder.h"

#include "drivers/reports/report_descriptor.h"

#include <cstdint>
#include <fmt/core.h>
#include <limits>

namespace tractus::drivers {

namespace {

constexpr HidUsage kJoystick = 0x0001'0004;
constexpr HidUsage kGamePad = 0x0001'0005;
constexpr HidUsage kSlider = 0x0001'0036;

bool belongs_to_a_game_controller(HidReportDescriptor const& descriptor, HidField const& field)
{
    for (auto collection = field.collection; collection;
         collection = descriptor.collections[*collection].parent) {
        auto const usage = descriptor.collections[*collection].usage;
        if (usage == kJoystick || usage == kGamePad)
            return true;
    }
    return false;
}

bool is_height(HidReportDescriptor const& descriptor, HidField const& field)
{
    return field.kind == HidReportKind::Input && field.usage == kSlider && !field.is_array
        && !field.is_relative && field.bit_size <= 32 && field.logical_minimum == 0
        && field.logical_maximum > 0
        && field.logical_maximum <= std::numeric_limits<std::int32_t>::max()
        && !belongs_to_a_game_controller(descriptor, field);
}

class HidSliderDecoder final : public HeightDecoder {
public:
    HidSliderDecoder(HidField const& field, std::size_t report_size)
        : field_(field)
        , report_size_(report_size)
    {
    }

    std::int32_t full_scale() const override
    {
        return static_cast<std::int32_t>(field_.logical_maximum);
    }

    using HeightDecoder::decode;
    Result<void> decode(Timestamp received, std::span<std::byte const> report,
                        std::vector<HeightSample>& out) override;

private:
    HidField field_;
    std::size_t report_size_; // Report size declared by the descriptor.
};

Result<void> HidSliderDecoder::decode(Timestamp received, std::span<std::byte const> report,
                                      std::vector<HeightSample>& out)
{
    if (field_.report_id != 0
        && (report.empty() || std::to_integer<std::uint8_t>(report[0]) != field_.report_id))
        return {};
    if (report.size() * 8 < field_.bit_offset + field_.bit_size)
        return fail(Fault::Device,
                    fmt::format("height report {}: {} bytes, expected {}", field_.report_id,
                                report.size(), report_size_));
    auto const counts = read_field(field_, report);
    if (counts > field_.logical_maximum)
        return fail(Fault::Device,
                    fmt::format("height report {}: {} counts, expected 0 to {}", field_.report_id,
                                counts, field_.logical_maximum));
    out.push_back({ .time = received,
                    .counts = static_cast<std::int32_t>(counts),
                    .full_scale = full_scale() });
    return {};
}

} // namespace

Result<std::unique_ptr<HeightDecoder>> make_hid_slider_decoder(DeviceInfo const& info)
{
    auto const who = fmt::format("{} ({:04x}:{:04x})", info.name.empty() ? "the device" : info.name,
                                 info.vendor_id, info.product_id);
    auto const descriptor = parse_report_descriptor(info.report_descriptor);
    if (!descriptor)
        return fail(descriptor.error().fault,
                    fmt::format("{}: {}", who, descriptor.error().message));
    for (auto const& field : descriptor->fields)
        if (is_height(*descriptor, field))
            return std::make_unique<HidSliderDecoder>(
                field, descriptor->report_size(HidReportKind::Input, field.report_id));
    return fail(
        Fault::User,
        fmt::format("{} is not a height sensor: its report descriptor has no absolute slider "
                    "from 0 to full scale",
                    who));
}

} // namespace tractus::drivers
