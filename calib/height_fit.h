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
    // The model to fit; no value: the simplest that the captures support.
    std::optional<HeightModelKind> kind {};

    // How exactly the person reads the ruler: the standard deviation of a capture. What a fit makes
    // of its parameters' errors never rests on less than this, with a bend seven tenths of it.
    double ruler_error_mm = 0.3;

    // How far the potentiometer's track may be off a straight one, in percent, as its data sheet
    // says: 0.1 to 2, with some tenths for a converter that loads it. The fit then has a bend
    // (track_bend_fit.h), and its errors know of it; so do the choice of the law and of what
    // slipped, which then bear with more. 0: nothing is known. Law and slips are then judged as of
    // a straight track, so that a false capture stands out as ever, and only the curve that comes
    // of them has a bend of some 0.25 %, as far as the captures make it likely: of five captures or
    // more, unless a law was asked for.
    double linearity_percent = 0;
};

// One number of a model with its standard error.
struct FitParameter {
    std::string_view name; // Key of the rig file: "mm_per_count".
    double value = 0;
    double standard_error = 0;
};

// How one kind of model fared, for the person who wonders about the choice.
struct HeightCandidate {
    HeightModelKind kind = HeightModelKind::Linear;
    std::size_t parameters = 0;
    std::size_t slipped = 0; // Captures that it would leave out.
    double rms_mm = 0;

    // How likely a gain over the simpler choice as great as this one would be by chance alone; no
    // value for the simplest.
    std::optional<double> p_value {};
};

// How much higher the model takes the carriage to be when it comes from below than when it comes
// from above: slack, friction, play.
struct Hysteresis {
    double mm = 0;
    double standard_error_mm = 0;
};

struct HeightFit {
    HeightModel model {};
    std::string reason; // Why this model, in a sentence.
    std::vector<HeightCandidate> candidates;

    std::vector<FitParameter> parameters;
    // Covariance of parameters_of(model), followed by the shifts of its track's bend.
    Eigen::MatrixXd covariance;

    // Standard deviation of the bend that the captures make likely, in percent of their range; 0
    // where the track was taken to be straight: see HeightFitOptions::linearity_percent.
    double bend_percent = 0;

    std::vector<double> residuals_mm; // Ruler less model, for each capture, slipped ones too.
    std::vector<std::size_t> slipped; // Captures that were left out, rising.
    double rms_mm = 0; // Root mean square over the captures that were used; as the next.
    double max_mm = 0;
    double capture_error_mm = 0; // Standard deviation of a capture, on which the errors rest.
    // How far captures lie beside the law and as little bend as the data sheet allows.
    double apart_mm = 0;

    std::optional<Hysteresis> hysteresis; // No value unless two captures came from either side.
    double noise_counts = 0;              // Noise at rest, of all captures.
    double low_counts = 0;                // The captures' range, slipped ones left out …
    double high_counts = 0;
    double low_mm
        = 0; // … and the model's heights there: low_mm < high_mm, whichever way it counts.
    double high_mm = 0;
};

// The standard error of a fit's height at a reading, as far as it comes from the parameters.
double height_error_mm(HeightFit const& fit, double counts);

// Fits the height sensor's model to captures, in the order in which they were made.
//
// The model is the simplest that the captures support: linear (2 parameters), string (4), monotone
// (as many as it has knots, 5 at least, and only where three captures more tell whether it is any
// good). A string is taken before a line if the ruler's error alone would make so great a gain in
// less than 1 of 20 cases: the sums of squares, over the ruler's variance, are compared by chi
// squared, since a ruler's error is known and five captures leave one over to tell it. A slip is
// dear there, as one capture in a hundred is one: otherwise a line without the capture in which the
// string shows most would do. A monotone curve is taken if its gain would come about by chance in
// less than 1 of 100 cases, by the F test for the extra sum of squares (G. Seber, C. Wild,
// "Nonlinear Regression", 1989, section 5.3): it comes nearer to a string's curve than any ruler
// can tell, so that the two are compared as if one contained the other; its number of knots is the
// one with the least estimated variance.
//
// A capture that lies apart is taken for a slip of the ruler or of the tongue if without it the sum
// of squares falls by more than (4 s)^2, s the ruler's error or the rest's standard deviation if
// that is greater. It is left out and named, and counts as a parameter in the test (the mean shift
// model of R. Cook and S. Weisberg, "Residuals and Influence in Regression", 1982). So it goes on
// with the worst one, for at most a fifth of the captures, and as long as more are left than the
// model has parameters. A monotone curve leaves out neither the lowest nor the highest capture: it
// could be anywhere there.
//
// Standard errors are those of the linear approximation, times the greater one of the ruler's error
// (known before, of type B as the "Guide to the expression of uncertainty in measurement", JCGM
// 100:2008, has it) and the residuals' own standard deviation. What the track may bend by, and what
// up and down differ by, are part of them wherever a bend is fitted. There the ruler's error is
// what the captures make likely, from seven tenths of what was said to twice as much, and residuals
// that one or two captures over leave count twice, as Student's quantiles have it: a ruler that is
// read worse than was said is seen as far as seven captures can show it, which is not far.
//
// Fails, as the user's fault, with a sentence that says what to do: fewer captures than parameters
// or than two, heights all the same, heights that do not follow one direction, readings that stay
// the same while the ruler rises (a slack string).
Result<HeightFit> fit_height(std::span<HeightCapture const> captures,
                             HeightFitOptions const& options = {});

// Returns the side from which the surface came to a height, given the one before it; no value: from
// nowhere.
HeightCapture::From direction(std::optional<double> before_mm, double ruler_mm);

// Fills in each capture's `from`, from the heights in their order.
void tell_directions(std::vector<HeightCapture>& captures);

// "linear", "string" or "monotone".
std::string_view name_of(HeightModelKind kind);
std::optional<HeightModelKind> parse_height_model_kind(std::string_view name);

} // namespace tractus::calib
