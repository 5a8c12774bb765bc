#include "drivers/tablets/pen_decoders.h"

#include "drivers/pens/descriptor_decoder.h"
#include "drivers/reports/event_pen.h"
#include "drivers/tablets/tablet_decoder.h"

namespace tractus::drivers {

// Clears the ids, so that no habits are looked up: the kernel's driver has already corrected the
// events.
static Result<std::unique_ptr<PenDecoder>> make_event_pen_decoder(DeviceInfo info)
{
    info.vendor_id = 0;
    info.product_id = 0;
    return make_descriptor_decoder(info);
}

Result<std::unique_ptr<PenDecoder>> make_pen_decoder(DeviceInfo const& info)
{
    if (has_event_pen_reports(info))
        return make_event_pen_decoder(info);
    if (auto const match = find_tablet(info))
        return make_tablet_decoder(info, *match);
    return make_descriptor_decoder(info);
}

} // namespace tractus::drivers
