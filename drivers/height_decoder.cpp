#include "drivers/height_decoder.h"

#include <fmt/core.h>
#include <limits>

namespace tractus {

static constexpr HidUsage kJoystick = 0x0001'0004;
static constexpr HidUsage kGamePad = 0x0001'0005;
static constexpr HidUsage kSlider = 0x0001'0036;

static bool belongs_to_a_game_controller(HidReportDescriptor const& descriptor,
                                         HidField const& field)
{
    for (auto collection = field.collection; collection;
         collection = descriptor.collections[*collection].parent) {
        auto const usage = descriptor.collections[*collection].usage;
        if (usage == kJoystick || usage == kGamePad)
            return true;
    }
    return false;
}

static bool is_height(HidReportDescriptor const& descriptor, HidField const& field)
{
    return field.kind == HidReportKind::Input && field.usage == kSlider && !field.is_array
        && !field.is_relative && field.bit_size <= 32 && field.logical_minimum == 0
        && field.logical_maximum > 0
        && field.logical_maximum <= std::numeric_limits<std::int32_t>::max()
        && !belongs_to_a_game_controller(descriptor, field);
}

Result<HeightDecoder> HeightDecoder::create(DeviceInfo const& info)
{
    auto const who = fmt::format("{} ({:04x}:{:04x})", info.name.empty() ? "the device" : info.name,
                                 info.vendor_id, info.product_id);
    auto const descriptor = parse_report_descriptor(info.report_descriptor);
    if (!descriptor)
        return fail(descriptor.error().fault,
                    fmt::format("{}: {}", who, descriptor.error().message));
    for (auto const& field : descriptor->fields)
        if (is_height(*descriptor, field))
            return HeightDecoder(field,
                                 descriptor->report_size(HidReportKind::Input, field.report_id));
    return fail(
        Fault::User,
        fmt::format("{} is not a height sensor: its report descriptor has no absolute slider "
                    "from 0 to full scale",
                    who));
}

Result<std::optional<HeightSample>> HeightDecoder::decode(Timestamp received,
                                                          std::span<std::byte const> report) const
{
    if (field_.report_id != 0
        && (report.empty() || std::to_integer<std::uint8_t>(report[0]) != field_.report_id))
        return std::nullopt;
    if (report.size() * 8 < field_.bit_offset + field_.bit_size)
        return fail(Fault::Device,
                    fmt::format("height report {}: {} bytes, expected {}", field_.report_id,
                                report.size(), report_size_));
    auto const counts = read_field(field_, report);
    if (counts > field_.logical_maximum)
        return fail(Fault::Device,
                    fmt::format("height report {}: {} counts, expected 0 to {}", field_.report_id,
                                counts, field_.logical_maximum));
    return HeightSample { .time = received,
                          .counts = static_cast<std::int32_t>(counts),
                          .full_scale = full_scale() };
}

} // namespace tractus
