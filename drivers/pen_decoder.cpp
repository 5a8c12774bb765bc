#include "drivers/pen_decoder.h"

#include "drivers/pens/descriptor_decoder.h"

namespace tractus {

Result<std::unique_ptr<PenDecoder>> make_pen_decoder(DeviceInfo const& info)
{
    return make_descriptor_decoder(info);
}

} // namespace tractus
