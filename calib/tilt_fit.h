#pragma once

#include "calib/rig.h"
#include "drivers/reports/pen_sample.h"
#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <span>

namespace tractus::calib {

// How far beside its nib a tablet sees a pen that leans, from a nib that stays in one place while
// the pen is leaned around.
struct TiltFit {
    Vec2 coil_height_mm = Vec2::Zero();       // Rig::coil_height_mm.
    Vec2 coil_height_error_mm = Vec2::Zero(); // Standard errors, see below.

    // The least and the greatest tilt towards +x and +y, a fortieth of the samples at either end
    // left out.
    Vec2 least_tilt_rad = Vec2::Zero();
    Vec2 most_tilt_rad = Vec2::Zero();

    double rms_mm = 0; // Root mean square by which the nib strayed.
    std::size_t touches = 0;

    // Whether there is nothing to correct: along both axes within two standard errors of zero.
    bool is_corrected() const;
};

// Fits place = nib + coil height * lean to what the pen sent while it touched, by itself for x and
// for y, so that a tablet whose tilt counts the other way round shows as a height below zero. The
// rig's own coil height does not matter.
//
// No fit can tell a coil's height from a nib that shifts in its dent as the pen is leaned. The
// standard errors hold 0.06 mm for that: a shift of up to 0.1 mm times the lean, whichever way. A
// tilt's noise makes heights come out short by its variance over that of the leans, 1 % at the
// worst.
//
// Fails, as the user's fault, with what to do: a tablet that tells no tilt, fewer than 200 touches,
// tilts that span less than 40 degrees along an axis, a nib that moved (by more than 1 mm over half
// a second, in the mean).
Result<TiltFit> fit_tilt(std::span<drivers::PenSample const> pens);

// The rig with the fit's coil height; zero where the tablet corrects for it.
Rig with_coil_height(Rig rig, TiltFit const& fit);

} // namespace tractus::calib
