#pragma once

#include "calib/height_capture.h"
#include "calib/height_model.h"
#include "calib/height_model_fit.h"
#include "engine/base/result.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::calib {

struct HeightFitOptions {
    // The model to fit; no value: the simplest one that the captures support.
    std::optional<HeightModelKind> kind {};

    // Standard deviation of a height read from the ruler. The standard errors of a fit never assume
    // less than this or, with a bend, less than 70 % of it.
    double ruler_error_mm = 0.3;

    // Linearity of the potentiometer's track in percent, as in its data sheet: 0.1 to 2, and some
    // tenths more for a converter that loads it. The fit then includes a bend (track_bend_fit.h),
    // and its errors, the choice of the law and the detection of slips allow for it. 0: unknown.
    // Law and slips are then judged as for a straight track, so that a wrong capture still stands
    // out, and only the resulting curve gets a bend of about 0.25 %, as far as the captures make it
    // likely; this needs five captures or more, and no particular law must have been requested.
    double linearity_percent = 0;
};

// One parameter of a model with its standard error.
struct FitParameter {
    std::string_view name; // Key in the rig file, such as "mm_per_count".
    double value = 0;
    double standard_error = 0;
};

// How one kind of model fits the captures, shown to the user to explain the choice.
struct HeightCandidate {
    HeightModelKind kind = HeightModelKind::Linear;
    std::size_t parameters = 0;
    std::size_t slipped = 0; // Number of captures that this model would leave out.
    double rms_mm = 0;

    // Probability that an improvement over the simpler choice as great as this one arises by
    // chance; no value for the simplest model.
    std::optional<double> p_value {};
};

// Height by the model when the carriage comes from below minus that when it comes from above,
// caused by slack, friction or play.
struct Hysteresis {
    double mm = 0;
    double standard_error_mm = 0;
};

struct HeightFit {
    HeightModel model {};
    std::string reason; // Sentence that explains why this model was chosen.
    std::vector<HeightCandidate> candidates;

    std::vector<FitParameter> parameters;
    // Covariance of parameters_of(model), followed by the shifts of the knots of its track's bend.
    Eigen::MatrixXd covariance;

    // Standard deviation of the bend that the captures make likely, in percent of their range; 0 if
    // the track was taken to be straight (HeightFitOptions::linearity_percent).
    double bend_percent = 0;

    // Height by the ruler minus height by the model, for each capture, including slipped ones.
    std::vector<double> residuals_mm;
    std::vector<std::size_t> slipped; // Indices of captures that were left out, in rising order.
    // Root mean square and greatest absolute residual over the captures that were used.
    double rms_mm = 0;
    double max_mm = 0;
    double capture_error_mm = 0; // Standard deviation of a capture, on which the errors are based.
    // Standard deviation of the captures about the law, at least the ruler's error. The law allows
    // for a bend of the track only if HeightFitOptions::linearity_percent is given. The bend that
    // is otherwise added after the choice of the law does not reduce this value.
    double apart_mm = 0;

    // Difference between up and down; known only if at least two captures came from each side.
    std::optional<Hysteresis> hysteresis;
    double noise_counts = 0; // Standard deviation of the readings at rest, over all captures.
    double low_counts = 0;   // Range of the readings, without slipped captures.
    double high_counts = 0;
    // Heights by the model at the ends of the readings' range; low_mm < high_mm, also if readings
    // fall as the carriage rises.
    double low_mm = 0;
    double high_mm = 0;
};

// Returns the standard error of the fitted height at a reading, due to the parameters' errors
// alone.
double height_error_mm(HeightFit const& fit, double counts);

// Fits the height sensor's model to captures, given in the order in which they were made.
//
// The model is the simplest that the captures support: linear (2 parameters), string (4), monotone
// (as many as it has knots, at least 5, and only with three surplus captures to judge it). A string
// is preferred to a line if the ruler's error alone would cause so great an improvement in less
// than 1 of 20 cases: the sums of squares over the ruler's variance are compared by chi squared,
// since a ruler's error is known, and five captures leave only one to estimate it. A slip has a
// high cost in this comparison, because only one capture in a hundred is one: otherwise a line
// without the capture in which the string shows most would suffice. A monotone curve is preferred
// if its improvement would arise by chance in less than 1 of 100 cases, by the F test for the extra
// sum of squares (G. Seber, C. Wild, "Nonlinear Regression", 1989, section 5.3). It approximates a
// string's curve better than any ruler can resolve, so the two are compared as if one contained the
// other; it has the number of knots with the least estimated variance.
//
// An outlying capture is considered a slip (a misread ruler or a mistyped height) if leaving it out
// reduces the sum of squares by more than (4 s)^2, where s is the greater of the ruler's error and
// the standard deviation of the rest. It is left out and reported, and counts as a parameter in the
// test (the mean shift model of R. Cook and S. Weisberg, "Residuals and Influence in Regression",
// 1982). This is repeated with the worst capture, for at most a fifth of the captures, and as long
// as more are left than the model has parameters. A monotone curve keeps the lowest and the highest
// capture, because it is undetermined without them.
//
// Standard errors are those of the linear approximation, times the greater of the ruler's error
// (known beforehand; of type B in the "Guide to the expression of uncertainty in measurement", JCGM
// 100:2008) and the residuals' own standard deviation. If a bend is fitted, they include the
// possible bend of the track and the difference between up and down. The ruler's error is then the
// one that the captures make likely, from 70 % to 200 % of the given value, and residuals from one
// or two surplus captures count twice, as in Student's quantiles. A ruler read worse than stated is
// detected only as far as seven captures can show it, which is not far.
//
// Fails with a user error that says what to do: fewer than two captures, or fewer than parameters;
// equal heights; heights that do not follow one direction; readings that stay the same while the
// ruler rises (a slack string).
Result<HeightFit> fit_height(std::span<HeightCapture const> captures,
                             HeightFitOptions const& options = {});

// Returns the side from which the surface came to a height, given the previous one; Nowhere if
// there was none.
HeightCapture::From direction(std::optional<double> before_mm, double ruler_mm);

// Fills in each capture's `from`, from the order of the heights.
void assign_directions(std::vector<HeightCapture>& captures);

// Returns "linear", "string" or "monotone".
std::string_view name_of(HeightModelKind kind);
std::optional<HeightModelKind> parse_height_model_kind(std::string_view name);

} // namespace tractus::calib
