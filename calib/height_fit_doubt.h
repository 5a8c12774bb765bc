#pragma once

#include "calib/height_capture.h"
#include "calib/height_fit.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::calib {

// Reason why a rig made from a fit should not be kept.
struct HeightFitDoubt {
    // One sentence that says what is wrong with the captures. If another linearity of the
    // potentiometer, as in usual data sheets, would explain all captures, the sentence names it.
    std::string reason;

    // Captures that disagree with the others and should be measured again, in rising order. Empty
    // if none can be singled out.
    std::vector<std::size_t> captures {};
};

// Judges a fit by fit_height() with the same captures and options. There is a doubt
//
// - if the heights span less than 100 mm: this is a short travel, and often means heights in
//   centimetres;
// - if a capture's error, estimated from the residuals, is more than three times the ruler's: then
//   captures are wrong, or the sensor follows no known law;
// - if captures were left out, and fewer than three surplus captures confirm the rest.
//
// Disagreeing captures are found by trial, up to a third of all: those whose absence lets a line or
// a string fit the rest within three times the ruler's error, with two surplus captures to confirm
// it (least trimmed squares: P. Rousseeuw, "Least median of squares regression", JASA 79, 1984).
// One capture is tried first, then the best pair, then one more after the other. No value if there
// is no doubt.
std::optional<HeightFitDoubt> doubt_about(HeightFit const& fit,
                                          std::span<HeightCapture const> captures,
                                          HeightFitOptions const& options);

} // namespace tractus::calib
