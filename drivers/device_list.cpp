#include "drivers/device_list.h"

#include "drivers/gpio/gpio_adc.h"
#include "drivers/gpio/gpio_encoder.h"
#include "drivers/links/event_source.h"
#include "drivers/links/hid_source.h"
#include "drivers/reports/device_address.h"
#include "drivers/sensors/iio_channel.h"
#include "drivers/sensors/labjack_u3.h"
#include "drivers/sensors/linak_desk.h"
#include "drivers/sensors/mcp2221a.h"
#include "drivers/sensors/serial_line.h"
#include "drivers/sensors/usb_height_sensor.h"
#include "drivers/sensors/usb_sensor_list.h"
#include "drivers/tablets/open_tablet.h"
#include "drivers/tablets/usb_tablet.h"

#include <algorithm>
#include <fmt/core.h>
#include <iterator>
#include <mutex>
#include <utility>

namespace tractus::drivers {

namespace {

// Guards hidapi's calls, which must not run at the same time because hidapi stores its last error
// globally.
std::mutex& library_mutex()
{
    static std::mutex mutex;
    return mutex;
}

} // namespace

std::vector<DeviceInfo> list_devices()
{
    std::lock_guard const lock(library_mutex());
    auto devices = enumerate_hid();
    for (auto&& more :
         { list_event_pens(), list_usb_height_sensors(), list_serial_lines(), list_iio_channels() })
        devices.insert(devices.end(), more.begin(), more.end());
    return devices;
}

std::vector<DeviceInfo> list_device_addresses()
{
    auto devices = list_devices();
    auto tablets = list_usb_tablets();
    std::move(tablets.begin(), tablets.end(), std::back_inserter(devices));
    return devices;
}

static Result<DeviceInfo> find_at_address(std::string_view text)
{
    auto const address = TRY(parse_device_address(text));
    if (std::holds_alternative<GpioAddress>(address))
        return describe_gpio_adc(std::string(text));
    if (std::holds_alternative<GpioEncoderAddress>(address))
        return describe_gpio_encoder(std::string(text));
    if (std::holds_alternative<SerialAddress>(address))
        return describe_serial_line(std::string(text));
    if (std::holds_alternative<IioAddress>(address))
        return describe_iio_channel(std::string(text));
    auto devices = list_device_addresses();
    auto const found = std::find_if(devices.begin(), devices.end(),
                                    [&](auto const& info) { return info.location == text; });
    if (found != devices.end())
        return std::move(*found);
    return fail(
        Fault::User,
        fmt::format("there is no device at {}: \"tractus devices\" lists those there are", text));
}

Result<DeviceInfo> find_device(std::string_view text)
{
    // A GPIO chip's label may contain an @, and GPIO converters have no settings, so the text is
    // not split.
    auto const at = text.starts_with("gpio:") ? text.size() : std::min(text.find('@'), text.size());
    auto info = TRY(find_at_address(text.substr(0, at)));
    info.settings = text.substr(std::min(at + 1, text.size()));
    return info;
}

Result<std::unique_ptr<ReportSource>> open_device(DeviceInfo info)
{
    auto const address = TRY(parse_device_address(info.location));
    std::lock_guard const lock(library_mutex());
    if (std::holds_alternative<UsbAddress>(address))
        return is_labjack_u3(info) ? open_labjack_u3(std::move(info))
                                   : open_usb_height_sensor(std::move(info));
    if (std::holds_alternative<SerialAddress>(address))
        return open_serial_line(std::move(info));
    if (std::holds_alternative<IioAddress>(address))
        return open_iio_channel(std::move(info));
    if (is_mcp2221a(info))
        return open_mcp2221a(std::move(info));
    if (!info.settings.empty())
        return fail(Fault::User,
                    fmt::format("{} at {} has no settings: leave @{} away", info.name,
                                info.location, info.settings));
    if (std::holds_alternative<EventAddress>(address))
        return open_event_pen(std::move(info));
    if (std::holds_alternative<GpioAddress>(address))
        return open_gpio_adc(std::move(info));
    if (std::holds_alternative<GpioEncoderAddress>(address))
        return open_gpio_encoder(info);
    if (is_linak_desk(info))
        return open_linak_desk(std::move(info));
    return open_tablet(std::move(info));
}

} // namespace tractus::drivers
