#include "drivers/tablets/tablet_parameters.h"

#include "drivers/usb/string_descriptor.h"

namespace tractus::drivers {

Vec2 TabletParameters::size_mm() const
{
    return Vec2(x_maximum, y_maximum) / counts_per_inch * 25.4;
}

std::optional<TabletParameters> parse_parameters(int index, std::string_view text)
{
    constexpr double kMinTabletSide_mm = 20, kMaxTabletSide_mm = 800;
    constexpr std::int32_t kMinCountsPerInch = 500, kMaxCountsPerInch = 10'500;
    auto const bytes = string_descriptor_bytes(text);
    auto const number = [&](std::size_t at, std::size_t size) {
        std::int32_t value = 0;
        while (size-- > 0)
            value = value << 8 | std::to_integer<std::int32_t>(bytes[at + size]);
        return value;
    };
    TabletParameters result;
    if (index == 200 && bytes.size() >= 16)
        result = { number(0, 3), number(3, 3), number(6, 2), number(8, 2) };
    else if (index == 100 && bytes.size() >= 10)
        result = { number(0, 2), number(2, 2), number(6, 2), number(8, 2) };
    if (result.pressure_maximum <= 0 || result.counts_per_inch < kMinCountsPerInch
        || result.counts_per_inch > kMaxCountsPerInch)
        return std::nullopt;
    auto const size_mm = result.size_mm();
    if (size_mm.minCoeff() < kMinTabletSide_mm || size_mm.maxCoeff() > kMaxTabletSide_mm)
        return std::nullopt;
    return result;
}

} // namespace tractus::drivers
