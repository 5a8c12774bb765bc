#pragma once

#include "calib/height_capture.h"
#include "calib/height_model.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tractus::calib {

// Fits of single models, without judgement: height_fit.h chooses among them.

enum class HeightModelKind {
    Linear,
    String,
    Monotone,
};

// How many parameters a model of a kind has; a monotone one, at least.
std::size_t parameter_count(HeightModelKind kind);

// The fit of one model to some captures by least squares. What is least is the sum of the squared
// differences between ruler and model in millimetres, since the ruler errs more than a mean of
// hundreds of readings.
struct ModelFit {
    HeightModel model {};
    double sum_of_squares_mm2 = 0;

    // (J^T J)^-1, J in millimetres per parameter, in the order of parameters_of(model): times the
    // variance of a capture, the covariance of the parameters.
    Eigen::MatrixXd unit_covariance {};
};

// Knots of a monotone model: `count` of them, at readings among those of the captures, so that each
// piece has its share of captures.
struct MonotoneKnots {
    std::size_t count = 5;
};

// The captures must outnumber, or be as many as, the parameters. No value if nothing fits: a
// monotone model whose captures do not rise.
std::optional<ModelFit> fit_linear(std::span<HeightCapture const> captures);
std::optional<ModelFit> fit_string(std::span<HeightCapture const> captures);
std::optional<ModelFit> fit_monotone(std::span<HeightCapture const> captures,
                                     MonotoneKnots const& knots);

// The derivative of a model's height at a reading by its parameters, then by the shifts of its
// track's bend.
Eigen::VectorXd height_gradient(HeightModel const& model, double counts);

} // namespace tractus::calib
