#include "drivers/height_decoders.h"

#include "drivers/gpio/gpio_adc.h"
#include "drivers/gpio/gpio_encoder.h"
#include "drivers/sensors/height_frame_decoder.h"
#include "drivers/sensors/hid_slider_decoder.h"
#include "drivers/sensors/iio_channel.h"
#include "drivers/sensors/labjack_u3.h"
#include "drivers/sensors/linak_desk.h"
#include "drivers/sensors/mcp2221a.h"
#include "drivers/sensors/serial_line.h"

namespace tractus::drivers {

Result<std::unique_ptr<HeightDecoder>> make_height_decoder(DeviceInfo const& info)
{
    if (is_gpio_adc(info))
        return make_gpio_adc_decoder(info);
    if (is_gpio_encoder(info))
        return make_gpio_encoder_decoder();
    if (is_serial_line(info))
        return make_serial_line_decoder(info);
    if (is_iio_channel(info))
        return make_iio_channel_decoder(info);
    if (is_height_frame_device(info))
        return make_height_frame_decoder(info);
    if (is_labjack_u3(info))
        return make_labjack_u3_decoder(info);
    if (is_mcp2221a(info))
        return make_mcp2221a_decoder(info);
    if (is_linak_desk(info))
        return make_linak_desk_decoder();
    return make_hid_slider_decoder(info);
}

} // namespace tractus::drivers
