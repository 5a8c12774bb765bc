#include "calib/track_bend_fit.h"

#include "calib/least_squares.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace tractus::calib {

namespace {

using Captures = std::span<HeightCapture const>;

constexpr Eigen::Index kBendKnots = 9;
// Share of the captures' range by which the knots extend beyond it.
constexpr double kBendMargin = 0.1;
// Correlation length of the bend, as a share of the captures' range.
constexpr double kBendLength = 0.3;
// Share of the bend whose changes along the track are too quick for captures to follow.
constexpr double kShortPart = 0.3;
constexpr double kStraightBefore = 0.2; // Prior probability of a straight track.
constexpr double kSpoolNear_mm = 500;   // Prior scale of a spool's distance from the table.
constexpr double kSpoolBelow_mm = 1250;
// Candidate standard deviations of the bend, as multiples of the data sheet's linearity.
constexpr std::array kDeviations { 0.0, 0.25, 0.5, 1.0, 2.0 };
constexpr double kNoPlayBefore = 0.5; // Prior probability that up and down agree.
// Candidate standard deviations of the difference between up and down.
constexpr std::array kPlays_mm { 0.0, 0.3, 1.0 };

// Candidate error of reading the ruler, as a multiple of the stated one, and its prior probability.
struct RulerError {
    double part = 1;
    double chance = 0;
};
constexpr std::array kRulerErrors { RulerError { 0.7, 0.55 }, RulerError { 1, 0.33 },
                                    RulerError { 2, 0.12 } };

// The bend's knots, and the matrix that converts independent numbers of unit variance to their
// shifts.
struct Track {
    Eigen::VectorXd counts {};
    Eigen::MatrixXd half_covariance {};

    TrackBend bend(Eigen::VectorXd const& numbers) const
    {
        Eigen::VectorXd const shifts = half_covariance * numbers;
        TrackBend bend;
        for (Eigen::Index i = 0; i < counts.size(); ++i)
            bend.push_back({ counts[i], shifts[i] });
        return bend;
    }
};

Track track_over(ReadingRange const& range, double deviation)
{
    double const reach = kBendMargin * range.width();
    Eigen::VectorXd const counts
        = Eigen::VectorXd::LinSpaced(kBendKnots, range.low - reach, range.high + reach);
    Eigen::MatrixXd covariance(kBendKnots, kBendKnots);
    for (Eigen::Index i = 0; i < kBendKnots; ++i)
        for (Eigen::Index j = 0; j < kBendKnots; ++j)
            covariance(i, j)
                = std::exp(-0.5
                           * std::pow((counts[i] - counts[j]) / (kBendLength * range.width()), 2))
                + (i == j ? 1e-6
                          : 0); // Regularisation: otherwise rounding makes the matrix indefinite.
    Eigen::LDLT<Eigen::MatrixXd> const halves(covariance);
    Eigen::MatrixXd const lower
        = halves.matrixL() * Eigen::MatrixXd(halves.vectorD().cwiseMax(0).cwiseSqrt().asDiagonal());
    return { counts,
             deviation * range.width()
                 * Eigen::MatrixXd(halves.transpositionsP().transpose() * lower) };
}

// Effects that a fit assumes in addition to the law.
struct Besides {
    std::optional<Track> track {}; // The bend is part of the fit; no value: the track is straight.
    double play_mm = 0; // Standard deviation of the difference between up and down; 0: they agree.

    Eigen::Index bend_numbers() const { return track ? kBendKnots : 0; }
    Eigen::Index numbers() const { return bend_numbers() + (play_mm > 0 ? 1 : 0); }
};

struct FittedBend {
    HeightModel model {};
    LeastSquares fit {};
    Besides besides {};
    double log_evidence = 0;
};

HeightModel model_of(HeightModel const& law, Besides const& besides, Eigen::VectorXd const& numbers)
{
    auto const count = parameters_of(law).size();
    auto const model = with_parameters(law, numbers.head(count));
    return with_bend(model,
                     besides.track ? besides.track->bend(numbers.segment(count, kBendKnots))
                                   : TrackBend());
}

// Returns +1 if the carriage came from below, -1 if from above, 0 otherwise.
double side_of(HeightCapture const& capture)
{
    return capture.from == HeightCapture::From::Below ? 1
        : capture.from == HeightCapture::From::Above  ? -1
                                                      : 0;
}

// True if there are enough captures from either side.
bool have_both_sides(Captures captures)
{
    constexpr int kEnough = 2;
    auto const from = [&](double side) {
        return std::count_if(captures.begin(), captures.end(),
                             [=](auto const& capture) { return side_of(capture) == side; });
    };
    return from(1) >= kEnough && from(-1) >= kEnough;
}

// Returns the misfits of the captures in ruler errors, followed by the prior terms: `numbers`, then
// for a string its spool's distance from the carriage's path and from the table, and
// doubt_at_ends().
std::optional<Eigen::VectorXd> misfits(HeightModel const& model, Eigen::VectorXd const& numbers,
                                       double play_mm, Captures captures, double ruler_error_mm)
{
    if (!is_valid(model))
        return std::nullopt;
    auto const count = static_cast<Eigen::Index>(captures.size());
    double const half_play_mm = play_mm > 0 ? play_mm / 2 * numbers[numbers.size() - 1] : 0;
    auto const doubt = doubt_at_ends(model, span_to_hold(captures));
    if (!doubt)
        return std::nullopt;
    Eigen::VectorXd result = Eigen::VectorXd::Zero(count + numbers.size() + 3);
    for (Eigen::Index i = 0; i < count; ++i) {
        auto const& capture = captures[static_cast<std::size_t>(i)];
        auto const height = height_mm(model, capture.counts);
        if (!height)
            return std::nullopt;
        result[i] = (*height - side_of(capture) * half_play_mm - capture.ruler_mm) / ruler_error_mm;
    }
    result.segment(count, numbers.size()) = numbers;
    if (auto const* string = std::get_if<StringHeight>(&model)) {
        result[count + numbers.size()] = string->offset_mm / kSpoolNear_mm;
        result[count + numbers.size() + 1] = string->base_mm / kSpoolBelow_mm;
        result[count + numbers.size() + 2] = *doubt;
    }
    return result;
}

// Returns the logarithm of the determinant of J^T J.
double log_determinant(Eigen::MatrixXd const& jacobian)
{
    Eigen::MatrixXd const r = jacobian.colPivHouseholderQr().matrixR();
    double sum = 0;
    for (Eigen::Index i = 0; i < jacobian.cols(); ++i)
        sum += 2 * std::log(std::max(std::abs(r(i, i)), 1e-300));
    return sum;
}

std::optional<FittedBend> fit_with(HeightModel const& law, Besides const& besides,
                                   Captures captures, double ruler_error_mm)
{
    auto const of_law = parameters_of(law);
    Eigen::VectorXd start = Eigen::VectorXd::Zero(of_law.size() + besides.numbers());
    start.head(of_law.size()) = of_law;
    Eigen::VectorXd steps = Eigen::VectorXd::Constant(start.size(), 1e-4);
    steps.head(of_law.size()) = 1e-6 * of_law.cwiseAbs().cwiseMax(1e-4);
    auto const fit = fit_least_squares(
        [&](Eigen::VectorXd const& numbers) {
            return misfits(model_of(law, besides, numbers), numbers.tail(besides.numbers()),
                           besides.play_mm, captures, ruler_error_mm);
        },
        start, steps);
    if (!fit)
        return std::nullopt;
    return FittedBend { .model = model_of(law, besides, fit->parameters),
                        .fit = *fit,
                        .besides = besides,
                        .log_evidence
                        = -0.5 * (fit->sum_of_squares() + log_determinant(fit->jacobian)) };
}

// Returns the covariance of the law's parameters, followed by the shifts of the bend's knots.
Eigen::MatrixXd covariance_of(FittedBend const& fitted)
{
    auto const count = parameters_of(fitted.model).size() + kBendKnots;
    Eigen::MatrixXd const unit = fitted.fit.unit_covariance.topLeftCorner(count, count);
    Eigen::MatrixXd to_shifts = Eigen::MatrixXd::Identity(count, count);
    to_shifts.bottomRightCorner(kBendKnots, kBendKnots) = fitted.besides.track->half_covariance;
    return small_product(small_product(to_shifts, unit), to_shifts.transpose());
}

// Likely standard deviations of the effects in addition to the law.
struct LikelyBesides {
    double bend = 0; // Standard deviation of the bend, as a share of the range.
    double play_mm = 0;
    double ruler_mm = 0; // Standard deviation of a capture, excluding bend and play.
};

// Returns the prior probability of candidate i: `of_first` for the first, and an equal share of the
// rest for each other.
double chance_before(std::size_t i, double of_first, std::size_t count)
{
    return i == 0 ? of_first : (1 - of_first) / static_cast<double>(count - 1);
}

struct BesidesTrial {
    LikelyBesides deviations {};
    double log_weight = 0;
};

// Adds the fit with the given deviations to the trials, unless it fails.
void try_deviations(HeightModel const& law, Captures captures, LikelyBesides const& deviations,
                    double chance, std::vector<BesidesTrial>& trials)
{
    Besides besides { .play_mm = deviations.play_mm };
    if (deviations.bend > 0)
        besides.track = track_over(reading_range(captures), deviations.bend);
    auto const fit = fit_with(law, besides, captures, deviations.ruler_mm);
    if (!fit)
        return;
    // The misfits are in ruler errors, so the normalisation of the density must be added to the
    // evidence.
    auto const log_height = -static_cast<double>(captures.size()) * std::log(deviations.ruler_mm);
    trials.push_back({ deviations, fit->log_evidence + log_height + std::log(chance) });
}

std::vector<BesidesTrial> try_besides(HeightModel const& law, Captures captures,
                                      double ruler_error_mm, double linearity)
{
    std::size_t const plays = have_both_sides(captures) ? kPlays_mm.size() : 1;
    std::vector<BesidesTrial> trials;
    for (std::size_t i = 0; i < kDeviations.size(); ++i)
        for (std::size_t k = 0; k < plays; ++k)
            for (auto const& ruler : kRulerErrors)
                try_deviations(
                    law, captures,
                    { kDeviations[i] * linearity, kPlays_mm[k], ruler.part * ruler_error_mm },
                    chance_before(i, kStraightBefore, kDeviations.size())
                        * chance_before(k, kNoPlayBefore, kPlays_mm.size()) * ruler.chance,
                    trials);
    return trials;
}

// Returns the root mean squares of the deviations, weighted by the evidence of the captures.
std::optional<LikelyBesides> mean_deviations(std::vector<BesidesTrial> const& trials)
{
    double most = -std::numeric_limits<double>::infinity();
    for (auto const& trial : trials)
        most = std::max(most, trial.log_weight);
    double sum = 0;
    LikelyBesides squares;
    for (auto const& [deviations, log_weight] : trials) {
        double const weight = std::exp(log_weight - most);
        sum += weight;
        squares.bend += weight * deviations.bend * deviations.bend;
        squares.play_mm += weight * deviations.play_mm * deviations.play_mm;
        squares.ruler_mm += weight * deviations.ruler_mm * deviations.ruler_mm;
    }
    if (trials.empty())
        return std::nullopt;
    return LikelyBesides { std::sqrt(squares.bend / sum), std::sqrt(squares.play_mm / sum),
                           std::sqrt(squares.ruler_mm / sum) };
}

} // namespace

std::optional<BentFit> fit_track_bend(HeightModel const& law, Captures captures,
                                      double ruler_error_mm, double linearity_percent)
{
    if (std::holds_alternative<MonotoneHeight>(law) || captures.empty())
        return std::nullopt;
    auto const likely
        = mean_deviations(try_besides(law, captures, ruler_error_mm, linearity_percent / 100));
    if (!likely)
        return std::nullopt;
    auto const fitted = fit_with(
        law,
        { .track = track_over(reading_range(captures), likely->bend), .play_mm = likely->play_mm },
        captures, likely->ruler_mm);
    if (!fitted)
        return std::nullopt;
    auto const rows = static_cast<Eigen::Index>(captures.size());
    auto const& unit = fitted->fit.unit_covariance;
    Eigen::MatrixXd const jacobian = fitted->fit.jacobian.topRows(rows);
    return BentFit { .model = fitted->model,
                     .sum_of_squares_mm2 = fitted->fit.residuals.head(rows).squaredNorm()
                         * likely->ruler_mm * likely->ruler_mm,
                     .covariance = covariance_of(*fitted),
                     .effective_parameters
                     = small_product(jacobian, unit).cwiseProduct(jacobian).sum(),
                     .deviation = likely->bend,
                     .capture_error_mm = likely->ruler_mm };
}

double error_beside_bend_mm(Captures captures, double ruler_error_mm, double linearity_percent)
{
    if (captures.empty())
        return ruler_error_mm;
    auto const [low, high]
        = std::minmax_element(captures.begin(), captures.end(),
                              [](auto const& a, auto const& b) { return a.ruler_mm < b.ruler_mm; });
    double const range_mm = high->ruler_mm - low->ruler_mm;
    return std::hypot(ruler_error_mm, kShortPart * linearity_percent / 100 * range_mm);
}

std::optional<ModelFit> fit_law_of_bent_track(HeightModel const& law, Captures captures,
                                              double error_mm, double linearity_percent)
{
    if (std::holds_alternative<MonotoneHeight>(law) || captures.empty())
        return std::nullopt;
    auto const track = track_over(reading_range(captures), linearity_percent / 100);
    auto const fitted = fit_with(law, { .track = track }, captures, error_mm);
    if (!fitted)
        return std::nullopt;
    double const variance_mm2 = error_mm * error_mm;
    return ModelFit { .model = fitted->model,
                      .sum_of_squares_mm2 = fitted->fit.sum_of_squares() * variance_mm2,
                      .unit_covariance = covariance_of(*fitted) / variance_mm2 };
}

} // namespace tractus::calib
