#include "drivers/reports/pen_decoder.h"

namespace tractus::drivers {

std::optional<PenSample> PenSilence::leave_after_silence(PenDecoder& pen, Timestamp now) const
{
    auto const limit = pen.silence_limit();
    if (!limit || now - last_ <= *limit)
        return std::nullopt;
    return pen.leave(last_ + *limit);
}

} // namespace tractus::drivers
