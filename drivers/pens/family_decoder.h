#pragma once

#include "drivers/pens/families.h"
#include "drivers/reports/pen_decoder.h"

#include <memory>

namespace tractus::drivers {

// Facts about one model of a tablet, since its reports do not tell them.
struct TabletShape {
    Vec2 size_mm = Vec2::Zero();  // Size of the active area; both sides above 0.
    bool is_size_assumed = false; // As in PenTraits.
    // The greatest counts. Both axes begin at 0 and their maxima are above 0.
    std::int32_t x_maximum = 0;
    std::int32_t y_maximum = 0;
    std::int32_t pressure_maximum = 0; // 0: the tablet does not report pressure.
    unsigned button_count = 2;         // Buttons on the pen's barrel, at most as the family has.
};

// Decodes one format of a maker's own, for one model.
std::unique_ptr<PenDecoder> make_family_decoder(PenFamily const& family, TabletShape const& shape);

} // namespace tractus::drivers
