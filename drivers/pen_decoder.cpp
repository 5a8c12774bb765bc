#include "drivers/pen_decoder.h"

#include "drivers/pens/descriptor_decoder.h"
#include "drivers/tablets/tablet_decoder.h"

namespace tractus {

std::optional<PenSample> PenSilence::leave_if_over(PenDecoder& pen, Timestamp now) const
{
    auto const limit = pen.silence_limit();
    if (!limit || now - last_ <= *limit)
        return std::nullopt;
    return pen.leave(last_ + *limit);
}

Result<std::unique_ptr<PenDecoder>> make_pen_decoder(DeviceInfo const& info)
{
    if (auto const match = find_tablet(info))
        return make_tablet_decoder(info, *match);
    return make_descriptor_decoder(info);
}

} // namespace tractus
