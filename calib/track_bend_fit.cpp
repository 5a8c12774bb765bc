#include "calib/track_bend_fit.h"

#include "calib/least_squares.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tractus {

namespace {

using Captures = std::span<HeightCapture const>;

constexpr Eigen::Index kBendKnots = 9;
constexpr double kBendMargin = 0.1;     // Of the range, by which the knots reach beyond it.
constexpr double kBendLength = 0.3;     // Of the range, over which the bend hardly changes.
constexpr double kShortPart = 0.3;      // Of the bend, too short for captures to follow.
constexpr double kStraightBefore = 0.2; // Chance of a straight track before the captures.
constexpr double kSpoolNear_mm = 500;   // How far from the table a spool may well stand.
constexpr double kSpoolBelow_mm = 1250;
// Standard deviations of the bend, in parts of what the data sheet says.
constexpr std::array kDeviations { 0.0, 0.25, 0.5, 1.0, 2.0 };

// The bend's knots, and what takes independent numbers of variance one to their shifts.
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
                + (i == j ? 1e-6 : 0); // Else rounding makes it indefinite.
    return { counts, deviation * range.width() * Eigen::MatrixXd(covariance.llt().matrixL()) };
}

struct FittedBend {
    HeightModel model {};
    LeastSquares fit {};
    Track track {};
    double log_evidence = 0;
};

HeightModel model_of(HeightModel const& law, Track const& track, Eigen::VectorXd const& numbers)
{
    auto const count = parameters_of(law).size();
    auto const model = with_parameters(law, numbers.head(count));
    return with_bend(model,
                     numbers.size() > count ? track.bend(numbers.tail(kBendKnots)) : TrackBend());
}

// Misfits in errors of the ruler, and what is known before: the bend's numbers, and that a string's
// spool stands somewhere near the table.
std::optional<Eigen::VectorXd> misfits(HeightModel const& model, Eigen::VectorXd const& bend,
                                       Captures captures, double ruler_error_mm)
{
    if (!is_valid(model))
        return std::nullopt;
    auto const count = static_cast<Eigen::Index>(captures.size());
    Eigen::VectorXd result = Eigen::VectorXd::Zero(count + bend.size() + 2);
    for (Eigen::Index i = 0; i < count; ++i) {
        auto const& capture = captures[static_cast<std::size_t>(i)];
        auto const height = height_mm(model, capture.counts);
        if (!height)
            return std::nullopt;
        result[i] = (*height - capture.ruler_mm) / ruler_error_mm;
    }
    result.segment(count, bend.size()) = bend;
    if (auto const* string = std::get_if<StringHeight>(&model)) {
        result[count + bend.size()] = string->offset_mm / kSpoolNear_mm;
        result[count + bend.size() + 1] = string->base_mm / kSpoolBelow_mm;
    }
    return result;
}

// Logarithm of the determinant of J^T J.
double log_determinant(Eigen::MatrixXd const& jacobian)
{
    Eigen::MatrixXd const r = jacobian.householderQr().matrixQR();
    double sum = 0;
    for (Eigen::Index i = 0; i < jacobian.cols(); ++i)
        sum += 2 * std::log(std::max(std::abs(r(i, i)), 1e-300));
    return sum;
}

std::optional<FittedBend> fit_with(HeightModel const& law, Track const& track, bool is_bent,
                                   Captures captures, double ruler_error_mm)
{
    auto const of_law = parameters_of(law);
    auto const of_bend = is_bent ? kBendKnots : 0;
    Eigen::VectorXd start = Eigen::VectorXd::Zero(of_law.size() + of_bend);
    start.head(of_law.size()) = of_law;
    Eigen::VectorXd steps = Eigen::VectorXd::Constant(start.size(), 1e-4);
    steps.head(of_law.size()) = 1e-6 * of_law.cwiseAbs().cwiseMax(1e-4);
    auto const fit = fit_least_squares(
        [&](Eigen::VectorXd const& numbers) {
            return misfits(model_of(law, track, numbers), numbers.tail(of_bend), captures,
                           ruler_error_mm);
        },
        start, steps);
    if (!fit)
        return std::nullopt;
    return FittedBend { .model = model_of(law, track, fit->parameters),
                        .fit = *fit,
                        .track = track,
                        .log_evidence
                        = -0.5 * (fit->sum_of_squares() + log_determinant(fit->jacobian)) };
}

// Covariance of the law's parameters, followed by the shifts of the bend's knots.
Eigen::MatrixXd covariance_of(FittedBend const& fitted)
{
    auto const& unit = fitted.fit.unit_covariance;
    Eigen::MatrixXd to_shifts = Eigen::MatrixXd::Identity(unit.rows(), unit.cols());
    to_shifts.bottomRightCorner(kBendKnots, kBendKnots) = fitted.track.half_covariance;
    return to_shifts * unit * to_shifts.transpose();
}

// The root of the mean square of the deviation, over what the captures make of each one.
double likely_deviation(HeightModel const& law, Captures captures, double ruler_error_mm,
                        double linearity)
{
    std::vector<double> logs;
    for (double const part : kDeviations) {
        double const deviation = part * linearity;
        auto const fit = fit_with(law, track_over(reading_range(captures), deviation),
                                  deviation > 0, captures, ruler_error_mm);
        double const prior
            = deviation > 0 ? (1 - kStraightBefore) / (kDeviations.size() - 1) : kStraightBefore;
        logs.push_back(fit ? fit->log_evidence + std::log(prior) : -1e300);
    }
    double const most = *std::max_element(logs.begin(), logs.end());
    double sum = 0;
    double squares = 0;
    for (std::size_t i = 0; i < logs.size(); ++i) {
        double const weight = std::exp(logs[i] - most);
        sum += weight;
        squares += weight * kDeviations[i] * kDeviations[i];
    }
    return linearity * std::sqrt(squares / sum);
}

} // namespace

std::optional<BentFit> fit_track_bend(HeightModel const& law, Captures captures,
                                      double ruler_error_mm, double linearity_percent)
{
    if (std::holds_alternative<MonotoneHeight>(law) || captures.empty())
        return std::nullopt;
    double const deviation
        = likely_deviation(law, captures, ruler_error_mm, linearity_percent / 100);
    auto const track = track_over(reading_range(captures), deviation);
    auto const fitted = fit_with(law, track, true, captures, ruler_error_mm);
    if (!fitted)
        return std::nullopt;
    auto const rows = static_cast<Eigen::Index>(captures.size());
    auto const& unit = fitted->fit.unit_covariance;
    Eigen::MatrixXd const jacobian = fitted->fit.jacobian.topRows(rows);
    return BentFit { .model = fitted->model,
                     .sum_of_squares_mm2 = fitted->fit.residuals.head(rows).squaredNorm()
                         * ruler_error_mm * ruler_error_mm,
                     .covariance = covariance_of(*fitted),
                     .effective_parameters = (jacobian * unit * jacobian.transpose()).trace(),
                     .deviation = deviation };
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
    auto const fitted = fit_with(law, track, true, captures, error_mm);
    if (!fitted)
        return std::nullopt;
    double const variance_mm2 = error_mm * error_mm;
    return ModelFit { .model = fitted->model,
                      .sum_of_squares_mm2 = fitted->fit.sum_of_squares() * variance_mm2,
                      .unit_covariance = covariance_of(*fitted) / variance_mm2 };
}

} // namespace tractus
