#include "drivers/tablets/pen_decoders.h"

#include "drivers/pens/descriptor_decoder.h"
#include "drivers/tablets/tablet_decoder.h"

namespace tractus::drivers {

Result<std::unique_ptr<PenDecoder>> make_pen_decoder(DeviceInfo const& info)
{
    if (auto const match = find_tablet(info))
        return make_tablet_decoder(info, *match);
    return make_descriptor_decoder(info);
}

} // namespace tractus::drivers
