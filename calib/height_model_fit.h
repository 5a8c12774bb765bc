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

// The heights over which a law has to hold: those of captures by the ruler, and a tenth of their
// span beyond either end, since a carriage seldom stops where the ruler did.
struct HeightSpan {
    double low_mm = 0;
    double high_mm = 0;
};

// The span of at least one capture.
HeightSpan span_to_hold(std::span<HeightCapture const> captures);

// How much a string's law is to be doubted because it ends close to the span, in standard
// deviations: 0 while string and carriage's way are far from a right angle over the whole span, 1
// where the string's end comes within a fiftieth of the span's height of it, and so on. A spool
// stands clear of the way. No value if the law ends within the span; 0 for other laws.
std::optional<double> doubt_at_ends(HeightModel const& model, HeightSpan const& span);

// The derivative of a model's height at a reading by its parameters, then by the shifts of its
// track's bend.
Eigen::VectorXd height_gradient(HeightModel const& model, double counts);

} // namespace tractus::calib
