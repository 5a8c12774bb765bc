#include "drivers/height_decoder.h"

#include "drivers/sensors/hid_slider_decoder.h"

namespace tractus {

Result<std::unique_ptr<HeightDecoder>> make_height_decoder(DeviceInfo const& info)
{
    return make_hid_slider_decoder(info);
}

} // namespace tractus
