#include "drivers/device_kind.h"

#include "drivers/height_decoders.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/tablets/pen_decoders.h"

#include <fmt/core.h>

namespace tractus::drivers {

static std::string describe_pen(PenTraits const& traits)
{
    auto text
        = fmt::format("pen tablet, {:.1f} x {:.1f} mm", traits.size_mm.x(), traits.size_mm.y());
    if (traits.is_size_assumed)
        text += " (assumed: it does not tell its size)";
    if (traits.has_pressure)
        text += fmt::format(", pressure to {}", traits.raw_pressure_maximum);
    if (traits.has_tilt)
        text += ", tilt";
    if (traits.has_eraser)
        text += ", eraser";
    if (traits.button_count > 0)
        text += fmt::format(", {} barrel button{}", traits.button_count,
                            traits.button_count == 1 ? "" : "s");
    return text;
}

DeviceDescription describe_device(DeviceInfo const& info)
{
    auto const pen = make_pen_decoder(info);
    if (pen)
        return { .kind = DeviceKind::Pen, .text = describe_pen((*pen)->traits()) };
    if (auto const height = make_height_decoder(info))
        return { .kind = DeviceKind::Height,
                 .text = fmt::format("height sensor, 0 to {}", (*height)->full_scale()) };
    return { .kind = DeviceKind::Other, .text = pen.error().message };
}

} // namespace tractus::drivers
