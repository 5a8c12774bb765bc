#include "drivers/device_kind.h"

#include "drivers/height_decoders.h"
#include "drivers/reports/device_address.h"
#include "drivers/reports/event_pen.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/sensors/iio_channel.h"
#include "drivers/sensors/serial_line.h"
#include "drivers/tablets/pen_decoders.h"

#include <fmt/core.h>
#include <utility>
#include <variant>

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

// Explains the state of a serial port or analogue input that the user has not named as a height
// sensor, or of a pen for which read permission is missing. Empty for other devices.
static std::string describe_unnamed(DeviceInfo const& info)
{
    if (has_event_pen_reports(info) && info.report_descriptor.empty())
        return "pen that gives input events, which you may not read: sudo adduser $USER input, "
               "then "
               "log in again";
    auto const address = parse_device_address(info.location);
    if (!address || is_serial_line(info) || is_iio_channel(info))
        return {};
    if (std::holds_alternative<SerialAddress>(*address))
        return fmt::format("serial line; a height sensor on it is read if it is named, such as "
                           "--device {}@115200,max=1023",
                           info.location);
    if (std::holds_alternative<IioAddress>(*address))
        return fmt::format("industrial I/O channel; read as a height sensor if it is named, "
                           "--device {}",
                           info.location);
    return {};
}

DeviceDescription describe_device(DeviceInfo const& info)
{
    if (auto text = describe_unnamed(info); !text.empty())
        return { .kind = DeviceKind::Other, .text = std::move(text) };
    auto const pen = make_pen_decoder(info);
    if (pen)
        return { .kind = DeviceKind::Pen, .text = describe_pen((*pen)->traits()) };
    if (auto const height = make_height_decoder(info))
        return { .kind = DeviceKind::Height,
                 .text = fmt::format("height sensor, 0 to {}", (*height)->full_scale()) };
    return { .kind = DeviceKind::Other, .text = pen.error().message };
}

} // namespace tractus::drivers
