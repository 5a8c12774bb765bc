#pragma once

#include "calib/height_capture.h"
#include "calib/height_model.h"
#include "calib/height_model_fit.h"

#include <Eigen/Core>
#include <optional>
#include <span>

namespace tractus::calib {

// A law together with the bend of its potentiometer's track.
struct BentFit {
    HeightModel model {};
    double sum_of_squares_mm2 = 0; // Excludes the difference between up and down.

    // Covariance of parameters_of(model), followed by the shifts of the bend's knots.
    Eigen::MatrixXd covariance {};

    // Effective number of parameters: the trace of the matrix that maps heights by the ruler to
    // heights by the model.
    double effective_parameters = 0;

    // Standard deviation of the track's bend that the captures make likely, as a share of their
    // range.
    double deviation = 0;

    // Standard deviation of a capture that the captures make likely, on which the covariance is
    // based.
    double capture_error_mm = 0;
};

// Refits a line or a string with a track that may be bent. The bend is a Gaussian process over the
// readings (C. Rasmussen, C. Williams, "Gaussian Processes for Machine Learning", 2006, chapters 2
// and 5) that hardly changes over a third of the captures' range. Its standard deviation is 0.25 to
// 2 times `linearity_percent` of that range, weighted by the evidence of the captures (Laplace's
// approximation); the prior probability of a straight track is one in five. The ruler's error must
// be above 0 and is the stated accuracy of reading it; 70 % to 200 % of it are considered, weighted
// by the evidence, and 200 % has a low prior probability.
//
// Captures from below and from above, if there are two of each, may differ by slack in the string;
// the model lies midway. The difference is part of the fit, with a standard deviation of 0 to 1 mm,
// weighted by the evidence too: a string with the same error each time is not a badly read ruler.
//
// No value if the law is monotone, or if nothing fits.
std::optional<BentFit> fit_track_bend(HeightModel const& law,
                                      std::span<HeightCapture const> captures,
                                      double ruler_error_mm, double linearity_percent);

// Returns the standard deviation of a capture without the smooth bend of the track. It combines the
// ruler's error with three tenths of `linearity_percent` of the captures' range, for bends too
// short for a few captures to follow.
double error_beside_bend_mm(std::span<HeightCapture const> captures, double ruler_error_mm,
                            double linearity_percent);

// Fits the kind of `law`, a line or a string, to captures of a track that may be bent, starting
// from `law`: the bend's standard deviation is `linearity_percent` of the captures' range. The sum
// of squares contains what the bend does not explain, and the cost of the bend; the covariance is
// of the parameters, followed by the shifts of the bend's knots.
//
// A slipped capture, or a string instead of a line, stands out as from a straight track, since a
// bend is smooth and known to be small. No value if the law is monotone, or if nothing fits.
std::optional<ModelFit> fit_law_of_bent_track(HeightModel const& law,
                                              std::span<HeightCapture const> captures,
                                              double error_mm, double linearity_percent);

} // namespace tractus::calib
