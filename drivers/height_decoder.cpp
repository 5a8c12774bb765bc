#include "drivers/height_decoder.h"

#include "drivers/gpio/gpio_adc.h"
#include "drivers/sensors/hid_slider_decoder.h"

namespace tractus {

Result<std::unique_ptr<HeightDecoder>> make_height_decoder(DeviceInfo const& info)
{
    if (is_gpio_adc(info))
        return make_gpio_adc_decoder(info);
    return make_hid_slider_decoder(info);
}

} // namespace tractus
