#pragma once

#include "drivers/pens/families.h"
#include "drivers/reports/pen_decoder.h"

#include <memory>

namespace tractus::drivers {

// Properties of one tablet model that its reports do not contain.
struct TabletShape {
    Vec2 size_mm = Vec2::Zero();  // Size of the active area; both sides above 0.
    bool is_size_assumed = false; // True if the size is a guess, as in PenTraits.
    // Maxima in counts, above 0. Both axes begin at 0.
    std::int32_t x_maximum = 0;
    std::int32_t y_maximum = 0;
    // Maximum pressure in counts; 0 if the tablet does not report pressure.
    std::int32_t pressure_maximum = 0;
    unsigned button_count = 2; // Number of buttons on the pen's barrel, at most that of the family.
};

// Makes a decoder of a maker's own format for one tablet model.
std::unique_ptr<PenDecoder> make_family_decoder(PenFamily const& family, TabletShape const& shape);

} // namespace tractus::drivers
