#pragma once

#include "calib/height_capture.h"
#include "calib/height_fit.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::calib {

// Why the rig that a fit gives had better not be kept.
struct HeightFitDoubt {
    // One sentence: what is wrong with the captures, and which linearity of the potentiometer would
    // make all of them right, if one of a usual data sheet does.
    std::string reason;

    // The captures that disagree with the others, rising: to be measured again. Empty if none can
    // be told from the rest.
    std::vector<std::size_t> captures {};
};

// Judges a fit of fit_height to the same captures with the same options. There is a doubt
//
//   - if the heights span less than 100 mm: it is not much of a travel, but often one in
//     centimetres;
//   - if a capture's error, as the residuals tell it, is more than three times the ruler's: then
//     captures are wrong, or the sensor follows no law that a fit knows;
//   - if captures were left out, and fewer than three are left over that would tell whether the
//     rest is right.
//
// Captures that disagree are found by trial, as long as they are a third at most: those whose
// absence lets a line or a string fit what is left within three times the ruler's error, with two
// captures over that confirm it (least trimmed squares: P. Rousseeuw, "Least median of squares
// regression", JASA 79, 1984); one capture, else the best pair, else one more after the other. No
// value if all is well.
std::optional<HeightFitDoubt> doubt_about(HeightFit const& fit,
                                          std::span<HeightCapture const> captures,
                                          HeightFitOptions const& options);

} // namespace tractus::calib
