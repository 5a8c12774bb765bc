#pragma once

#include "calib/height_capture.h"
#include "calib/height_model.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tractus::calib {

// Fits of single models; height_fit.h chooses among them.

enum class HeightModelKind {
    Linear,
    String,
    Monotone,
};

// Returns the number of parameters of a kind of model; for a monotone one, the least possible
// number.
std::size_t parameter_count(HeightModelKind kind);

// A least-squares fit of one model. It minimises the squared differences between ruler and model in
// millimetres, since the ruler has a greater error than a mean of hundreds of readings.
struct ModelFit {
    HeightModel model {};
    double sum_of_squares_mm2 = 0;

    // (J^T J)^-1, with J in millimetres per parameter in the order of parameters_of(model);
    // multiplied by the variance of a capture it is the covariance of the parameters.
    Eigen::MatrixXd unit_covariance {};
};

// Number of knots of a monotone model. A fit places them at readings of the captures, so that all
// pieces between knots have about the same number of captures.
struct MonotoneKnots {
    std::size_t count = 5;
};

// fit_linear(), fit_string() and fit_monotone() each fit one kind of model. There must be at least
// as many captures as parameters. No value if nothing fits, such as a monotone model for captures
// that do not rise.
std::optional<ModelFit> fit_linear(std::span<HeightCapture const> captures);
std::optional<ModelFit> fit_string(std::span<HeightCapture const> captures);
std::optional<ModelFit> fit_monotone(std::span<HeightCapture const> captures,
                                     MonotoneKnots const& knots);

// The heights over which a law has to hold: those of the captures by the ruler, and a tenth of
// their span beyond either end, since a carriage usually goes farther than the ruler.
struct HeightSpan {
    double low_mm = 0;
    double high_mm = 0;
};

// Returns the heights over which a law has to hold; there must be at least one capture.
HeightSpan span_to_hold(std::span<HeightCapture const> captures);

// Returns how implausible it is, in standard deviations, that a string's law ends so close to
// `span`, since spools stand clear of the carriage's path. The end of the string on the carriage is
// nearest to the spool's level at one end of the span. The result is 0 if it is still at least 6 %
// of the span away from that level, 1 at 3 %, and so on. No value if the law ends within the span;
// 0 for other laws.
std::optional<double> doubt_at_ends(HeightModel const& model, HeightSpan const& span);

// Returns the derivative of a model's height at a reading with respect to its parameters, then to
// the shifts of its track's bend.
Eigen::VectorXd height_gradient(HeightModel const& model, double counts);

} // namespace tractus::calib
