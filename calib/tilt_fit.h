#pragma once

#include "calib/rig.h"
#include "drivers/reports/pen_sample.h"
#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <span>

namespace tractus::calib {

// Apparent displacement of a leaning pen from its nib, fitted with a nib that stays in one place
// while the pen is leaned in all directions.
struct TiltFit {
    Vec2 coil_height_mm = Vec2::Zero();       // See Rig::coil_height_mm.
    Vec2 coil_height_error_mm = Vec2::Zero(); // Standard errors; see fit_tilt().

    // Least and greatest tilt towards +x and +y, ignoring a fortieth of the samples at either
    // extreme.
    Vec2 min_tilt_rad = Vec2::Zero();
    Vec2 most_tilt_rad = Vec2::Zero();

    double rms_mm = 0; // Root mean square distance of the nib from its fitted position.
    std::size_t touches = 0;

    // True if the tablet corrects the lean itself: both coil heights are within two standard errors
    // of zero.
    bool is_corrected() const;
};

// Fits position = nib + coil height * lean to a touching pen, separately for x and y, so that a
// tablet whose tilt has the opposite sign gives a negative height. The rig's own coil height is
// ignored.
//
// A coil's height cannot be distinguished from a nib that shifts in its dent as the pen is leaned.
// The standard errors include 0.06 mm for this: a shift of up to 0.1 mm times the lean, in any
// direction. Noise of the tilt makes the fitted heights too small, by the ratio of its variance to
// that of the leans: 1 % at worst.
//
// Fails with a user error that says what to do: a tablet without tilt, fewer than 200 touches,
// tilts that span less than 40 degrees along an axis, a nib that moved (by more than 1 mm on
// average over half a second).
Result<TiltFit> fit_tilt(std::span<drivers::PenSample const> pens);

// Returns the rig with the fitted coil height; zero if the tablet corrects for it.
Rig with_coil_height(Rig rig, TiltFit const& fit);

} // namespace tractus::calib
