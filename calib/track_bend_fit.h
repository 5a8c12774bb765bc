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
    double sum_of_squares_mm2 = 0; // Beside what up and down differ by.

    // Covariance of parameters_of(model), followed by the shifts of the bend's knots.
    Eigen::MatrixXd covariance {};

    // How many captures the fit has used up: the trace of the matrix that takes heights by the
    // ruler to heights by the model.
    double effective_parameters = 0;

    // Standard deviation of the track's bend, in parts of the captures' range, that the captures
    // make likely.
    double deviation = 0;

    // Standard deviation of a capture that the captures make likely, on which the covariance rests.
    double capture_error_mm = 0;
};

// Fits a line or a string to captures anew, with a track that may be bent. The bend is a Gaussian
// process over the readings (C. Rasmussen, C. Williams, "Gaussian Processes for Machine Learning",
// 2006, chapters 2 and 5) that hardly changes over a third of the captures' range. Its standard
// deviation is a quarter to twice `linearity_percent` of that range, as the captures' evidence
// tells (Laplace's approximation); one track in five is straight to begin with. The ruler's error
// is above 0 and says how well the person is thought to read it: seven tenths of it to twice as
// much, as the captures' evidence tells; what is twice is rare before.
//
// Captures from below and from above, where there are two of each, may differ by a slack in the
// string; the model lies midway. The difference is part of the fit, of a standard deviation of 0 to
// 1 mm, as their evidence tells, too: a string that errs the same way each time is not a person who
// reads a ruler badly.
//
// No value if the law is monotone, or if nothing fits.
std::optional<BentFit> fit_track_bend(HeightModel const& law,
                                      std::span<HeightCapture const> captures,
                                      double ruler_error_mm, double linearity_percent);

// Standard deviation of a capture beside such a bend: the ruler's, and three tenths of
// `linearity_percent` of the captures' range for what is too short for a few captures to follow.
double error_beside_bend_mm(std::span<HeightCapture const> captures, double ruler_error_mm,
                            double linearity_percent);

// Fits the kind of `law`, a line or a string, to captures of a track that may be bent, from `law`
// on: the bend's standard deviation is `linearity_percent` of the captures' range. The sum of
// squares is what the bend does not explain, and what it costs; the covariance is of the
// parameters, followed by the shifts of the bend's knots.
//
// A capture that slipped stands out of it, and a string out of a line, as they do from a straight
// track: a bend is smooth, and known to be small. No value as above.
std::optional<ModelFit> fit_law_of_bent_track(HeightModel const& law,
                                              std::span<HeightCapture const> captures,
                                              double error_mm, double linearity_percent);

} // namespace tractus::calib
