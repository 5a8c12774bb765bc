#include "calib/height_fit.h"

#include "calib/height_capture_checks.h"
#include "calib/track_bend_fit.h"
#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <fmt/core.h>
#include <functional>

namespace tractus::calib {

namespace {

using Captures = std::span<HeightCapture const>;

constexpr double kGreatestChance = 0.01; // Significance level for preferring a monotone curve.
// Significance level for preferring a string model. It is lenient, because a string where a line
// would do costs a tenth of a millimetre, and a line where the string runs at an angle costs many.
constexpr double kChanceOfAslant = 0.05;
constexpr double kSlipDeviations = 4;
// Penalty for a slip, -2 ln(0.01): one capture in a hundred slips.
constexpr double kRarityOfSlips = 9.2;
// Least number of surplus captures from which a variance can be estimated.
constexpr std::size_t kFreedomThatTells = 3;
constexpr std::size_t kMaxKnots = 12;
// Factor on a variance that was estimated from one to three surplus captures, because such an
// estimate is often too small. It is the square of the ratio of two quantiles for one standard
// error: Student's at three degrees of freedom, and the normal one.
constexpr double kSmallSampleFactor = 1.43;
// Linearity that data sheets usually state for the potentiometer of a string sensor.
constexpr double kUsualLinearity_percent = 0.25;
// Least number of captures from which a bend can be estimated.
constexpr std::size_t kFewestForBend = 5;
constexpr std::array<std::string_view, 3> kNames { "linear", "string", "monotone" };

// A model's fit and the captures that it leaves out.
struct RobustFit {
    HeightModelKind kind = HeightModelKind::Linear;
    ModelFit fit {};
    std::vector<std::size_t> slipped {}; // Indices of slipped captures, in rising order.
    std::size_t used = 0;

    std::size_t parameters() const
    {
        return static_cast<std::size_t>(parameters_of(fit.model).size());
    }
    // Returns the degrees of freedom; each slipped capture counts as a parameter.
    std::size_t freedom() const { return used - std::min(used, parameters()); }
    double variance_mm2() const
    {
        return freedom() > 0 ? fit.sum_of_squares_mm2 / static_cast<double>(freedom()) : 0;
    }
    double rms_mm() const { return std::sqrt(fit.sum_of_squares_mm2 / static_cast<double>(used)); }
};

using Fitter = std::function<std::optional<ModelFit>(Captures)>;

// Returns the best of all fits that leave out one more capture than `present` does.
std::optional<RobustFit> leave_one_out(Captures captures, RobustFit const& present,
                                       Fitter const& fitter)
{
    std::optional<RobustFit> best;
    for (std::size_t i = 0; i < captures.size(); ++i) {
        auto left_out = present.slipped;
        if (std::find(left_out.begin(), left_out.end(), i) != left_out.end())
            continue;
        left_out.push_back(i);
        auto const fit = fitter(captures_without(captures, left_out));
        if (!fit || (best && best->fit.sum_of_squares_mm2 <= fit->sum_of_squares_mm2))
            continue;
        best = RobustFit { present.kind, *fit, left_out, captures.size() - left_out.size() };
    }
    return best;
}

std::optional<RobustFit> fit_robustly(HeightModelKind kind, Captures captures,
                                      HeightFitOptions const& options, Fitter const& fitter)
{
    auto const whole = fitter(captures);
    if (!whole)
        return std::nullopt;
    double const error_mm
        = error_beside_bend_mm(captures, options.ruler_error_mm, options.linearity_percent);
    RobustFit present { kind, *whole, {}, captures.size() };
    while (present.slipped.size() < max_slips(captures.size()) && present.freedom() > 1) {
        auto const rest = leave_one_out(captures, present, fitter);
        if (!rest)
            break;
        double const variance = std::max(error_mm * error_mm, rest->variance_mm2());
        if (present.fit.sum_of_squares_mm2 - rest->fit.sum_of_squares_mm2
            <= kSlipDeviations * kSlipDeviations * variance)
            break;
        present = *rest;
    }
    std::sort(present.slipped.begin(), present.slipped.end());
    return present;
}

std::size_t distinct_readings(Captures captures)
{
    std::vector<double> counts;
    for (auto const& capture : captures)
        counts.push_back(capture.counts);
    std::sort(counts.begin(), counts.end());
    auto const end
        = std::unique(counts.begin(), counts.end(), [](double a, double b) { return b - a < 1; });
    return static_cast<std::size_t>(end - counts.begin());
}

// Fits with the number of knots that gives the least variance. If a monotone curve was requested
// but there are too few captures to determine that number, every capture becomes a knot. The lowest
// and highest capture are never left out, since no curve is defined beyond its captures.
std::optional<RobustFit> fit_best_monotone(Captures captures, HeightFitOptions const& options)
{
    auto const kind = HeightModelKind::Monotone;
    auto const range = reading_range(captures);
    auto const with_knots = [&](std::size_t knots) {
        return fit_robustly(kind, captures, options, [=](Captures some) -> std::optional<ModelFit> {
            if (some.size() < knots || reading_range(some) != range)
                return std::nullopt;
            return fit_monotone(some, { knots });
        });
    };
    std::optional<RobustFit> best;
    for (auto knots = parameter_count(kind);
         knots + kFreedomThatTells <= captures.size() && knots <= kMaxKnots; ++knots) {
        auto const fit = with_knots(knots);
        if (fit && fit->freedom() >= kFreedomThatTells
            && (!best || fit->variance_mm2() < best->variance_mm2()))
            best = fit;
    }
    if (!best && options.kind)
        best = with_knots(std::min(distinct_readings(captures), kMaxKnots));
    return best;
}

// Returns a fitter for a linear or string law on a track with the linearity in `options`.
Fitter law_fitter(std::optional<ModelFit> (*fit)(Captures), HeightFitOptions const& options)
{
    return [fit, options](Captures some) -> std::optional<ModelFit> {
        auto const straight = fit(some);
        if (!straight || !(options.linearity_percent > 0))
            return straight;
        return fit_law_of_bent_track(straight->model, some, options.ruler_error_mm,
                                     options.linearity_percent);
    };
}

std::optional<RobustFit> fit_kind(HeightModelKind kind, Captures captures,
                                  HeightFitOptions const& options)
{
    switch (kind) {
    case HeightModelKind::Linear:
        return fit_robustly(kind, captures, options, law_fitter(fit_linear, options));
    case HeightModelKind::String:
        return fit_robustly(kind, captures, options, law_fitter(fit_string, options));
    case HeightModelKind::Monotone:
        return fit_best_monotone(captures, options);
    }
    return std::nullopt;
}

// Returns the probability that a richer model without merit would improve on the simpler one as
// much as `rich` does. Residuals far below the ruler's accuracy are due to chance and do not count.
double chance_of_gain(RobustFit const& simple, RobustFit const& rich, double ruler_error_mm)
{
    double const min_variance = ruler_error_mm * ruler_error_mm / 9;
    if (rich.freedom() == 0 || rich.freedom() >= simple.freedom())
        return 1;
    auto const extra = static_cast<double>(simple.freedom() - rich.freedom());
    double const gain = simple.fit.sum_of_squares_mm2 - rich.fit.sum_of_squares_mm2;
    if (!(gain > 0))
        return 1;
    double const f = gain / extra / std::max(rich.variance_mm2(), min_variance);
    boost::math::fisher_f const distribution(extra, static_cast<double>(rich.freedom()));
    return boost::math::cdf(boost::math::complement(distribution, f));
}

// Returns how badly a line or a string fits captures of known error, as a chi-squared value. A slip
// counts as a parameter, and is penalised as a rare event.
double misfit(RobustFit const& fit, double variance_mm2)
{
    return fit.fit.sum_of_squares_mm2 / variance_mm2
        + static_cast<double>(fit.slipped.size())
        * (kSlipDeviations * kSlipDeviations + kRarityOfSlips);
}

// Returns the probability that the ruler's error alone would let a string improve on a line as much
// as this one does. The stated error of the ruler is more reliable than an estimate from a few
// captures. If there are at least three surplus captures, their variance counts too.
double chance_of_aslant(RobustFit const& line, RobustFit const& string, double ruler_error_mm)
{
    double variance_mm2 = ruler_error_mm * ruler_error_mm;
    if (string.freedom() >= kFreedomThatTells)
        variance_mm2 = std::max(variance_mm2, string.variance_mm2());
    double const gain = misfit(line, variance_mm2) - misfit(string, variance_mm2);
    if (!(gain > 0))
        return 1;
    auto const extra = static_cast<double>(string.parameters() - line.parameters());
    return boost::math::cdf(
        boost::math::complement(boost::math::chi_squared_distribution<double>(extra), gain));
}

struct Choice {
    RobustFit fit {};
    std::vector<HeightCandidate> candidates {};
    std::string reason {};
};

HeightCandidate candidate_of(RobustFit const& fit)
{
    return { .kind = fit.kind,
             .parameters = fit.parameters(),
             .slipped = fit.slipped.size(),
             .rms_mm = fit.rms_mm() };
}

std::string explain_no_role(Choice const& choice)
{
    auto const name = name_of(choice.fit.kind);
    if (choice.candidates.size() == 1)
        return fmt::format("{}: the only model that {} captures can tell", name, choice.fit.used);
    double p_value = 1;
    for (auto const& candidate : choice.candidates)
        if (candidate.p_value
            && (candidate.kind == choice.fit.kind || choice.fit.kind == HeightModelKind::Linear))
            p_value = std::min(p_value, *candidate.p_value);
    if (choice.fit.kind == HeightModelKind::Linear)
        return fmt::format("linear: what richer models gain may be chance (F test, p = {:.2g})",
                           p_value);
    return fmt::format(
        "{}: it gains more than chance over simpler ones ({}, p = {:.2g})", name,
        choice.fit.kind == HeightModelKind::String ? "by the ruler's error" : "F test", p_value);
}

Result<Choice> choose_model(Captures captures, HeightFitOptions const& options)
{
    std::optional<Choice> choice;
    std::vector<HeightCandidate> candidates;
    for (auto const kind :
         { HeightModelKind::Linear, HeightModelKind::String, HeightModelKind::Monotone }) {
        // A model without surplus captures cannot be compared with simpler ones.
        if (captures.size() < parameter_count(kind) + (kind == HeightModelKind::Linear ? 0 : 1))
            continue;
        auto const fit = fit_kind(kind, captures, options);
        if (!fit)
            continue;
        candidates.push_back(candidate_of(*fit));
        if (choice)
            candidates.back().p_value = kind == HeightModelKind::String
                ? chance_of_aslant(choice->fit, *fit, options.ruler_error_mm)
                : chance_of_gain(choice->fit, *fit, options.ruler_error_mm);
        double const enough = kind == HeightModelKind::String ? kChanceOfAslant : kGreatestChance;
        if (!choice || *candidates.back().p_value < enough)
            choice = Choice { .fit = *fit };
    }
    if (!choice)
        return fail(Fault::User,
                    "no model fits the captures: check what was typed and capture them again");
    choice->candidates = std::move(candidates);
    choice->reason = explain_no_role(*choice);
    return *choice;
}

Result<Choice> fit_asked_kind(Captures captures, HeightFitOptions const& options)
{
    auto const kind = *options.kind;
    auto const needed = kind == HeightModelKind::Monotone ? 2 : parameter_count(kind);
    if (captures.size() < needed)
        return fail(Fault::User,
                    fmt::format("a {} model has {} parameters and there are only {} captures: "
                                "capture at least {} more heights",
                                name_of(kind), needed, captures.size(), needed - captures.size()));
    auto const fit = fit_kind(kind, captures, options);
    if (!fit)
        return fail(Fault::User,
                    fmt::format("a {} model does not fit the captures: choose another, or leave "
                                "the choice to the program",
                                name_of(kind)));
    return Choice { .fit = *fit,
                    .candidates = { candidate_of(*fit) },
                    .reason = fmt::format("{}: as was asked for", name_of(kind)) };
}

std::vector<std::string_view> parameter_names(HeightModel const& model)
{
    if (std::holds_alternative<LinearHeight>(model))
        return { "mm_per_count", "zero_counts" };
    if (std::holds_alternative<StringHeight>(model))
        return { "mm_per_count", "zero_length_mm", "offset_mm", "base_mm" };
    return std::vector<std::string_view>(static_cast<std::size_t>(parameters_of(model).size()),
                                         "knot_mm");
}

std::vector<FitParameter> parameters_with_errors(HeightModel const& model,
                                                 Eigen::MatrixXd const& covariance)
{
    auto const values = parameters_of(model);
    auto const names = parameter_names(model);
    std::vector<FitParameter> parameters;
    for (Eigen::Index i = 0; i < values.size(); ++i)
        parameters.push_back({ .name = names[static_cast<std::size_t>(i)],
                               .value = values[i],
                               .standard_error = std::sqrt(std::max(0.0, covariance(i, i))) });
    return parameters;
}

struct Mean {
    double value = 0;
    double variance = 0; // Variance of the mean value.
    std::size_t count = 0;
};

Mean mean_of(std::vector<double> const& values)
{
    Mean mean { .count = values.size() };
    auto const count = static_cast<double>(values.size());
    for (double const value : values)
        mean.value += value / count;
    for (double const value : values)
        mean.variance += (value - mean.value) * (value - mean.value) / (count * (count - 1));
    return mean;
}

std::optional<Hysteresis> hysteresis_of(Captures captures, HeightFit const& fit,
                                        double ruler_error_mm)
{
    std::vector<double> from_below;
    std::vector<double> from_above;
    for (std::size_t i = 0; i < captures.size(); ++i) {
        if (std::binary_search(fit.slipped.begin(), fit.slipped.end(), i))
            continue;
        if (captures[i].from == HeightCapture::From::Below)
            from_below.push_back(-fit.residuals_mm[i]);
        else if (captures[i].from == HeightCapture::From::Above)
            from_above.push_back(-fit.residuals_mm[i]);
    }
    if (from_below.size() < 2 || from_above.size() < 2)
        return std::nullopt;
    auto const up = mean_of(from_below);
    auto const down = mean_of(from_above);
    // A few captures may agree by chance, so the error is at least that of the ruler.
    double const min_variance = std::pow(std::max(fit.capture_error_mm, ruler_error_mm), 2)
        * (1 / static_cast<double>(up.count) + 1 / static_cast<double>(down.count));
    return Hysteresis { .mm = up.value - down.value,
                        .standard_error_mm
                        = std::sqrt(std::max(up.variance + down.variance, min_variance)) };
}

double pooled_noise(Captures captures)
{
    double squares = 0;
    double readings = 0;
    for (auto const& capture : captures) {
        auto const weight = static_cast<double>(capture.readings);
        squares += weight * capture.noise_counts * capture.noise_counts;
        readings += weight;
    }
    return readings > 0 ? std::sqrt(squares / readings) : 0;
}

void tell_range(Captures captures, HeightFit& fit)
{
    auto const range = reading_range(captures_without(captures, fit.slipped));
    fit.low_counts = range.low;
    fit.high_counts = range.high;
    auto const one = height_mm(fit.model, fit.low_counts);
    auto const other = height_mm(fit.model, fit.high_counts);
    fit.low_mm = std::min(one.value_or(0),
                          other.value_or(0)); // A missing height is reported by check_range().
    fit.high_mm = std::max(one.value_or(0), other.value_or(0));
}

// Returns the linearity to assume: the given one or, without one, that of usual potentiometers if
// there are enough captures and no particular law was requested.
double linearity_to_fit_percent(HeightFitOptions const& options, std::size_t captures)
{
    bool const may_assume = !options.kind && captures >= kFewestForBend;
    return options.linearity_percent > 0 || !may_assume ? options.linearity_percent
                                                        : kUsualLinearity_percent;
}

// Adds the bend of the potentiometer's track to the fit.
void bend_track(Captures captures, HeightFitOptions const& options, HeightFit& fit)
{
    auto const used = captures_without(captures, fit.slipped);
    double const linearity_percent = linearity_to_fit_percent(options, used.size());
    if (!(linearity_percent > 0))
        return;
    auto const bent = fit_track_bend(fit.model, used, options.ruler_error_mm, linearity_percent);
    if (!bent)
        return;
    double const freedom = static_cast<double>(used.size()) - bent->effective_parameters;
    double const likely_mm2 = bent->capture_error_mm * bent->capture_error_mm;
    double variance_mm2 = likely_mm2;
    if (freedom >= 1)
        variance_mm2
            = std::max(variance_mm2, kSmallSampleFactor * bent->sum_of_squares_mm2 / freedom);
    fit.model = bent->model;
    fit.capture_error_mm = std::sqrt(variance_mm2);
    fit.covariance = bent->covariance * variance_mm2 / likely_mm2;
    fit.bend_percent = 100 * bent->deviation;
}

void tell_residuals(Captures captures, HeightFit& fit)
{
    double squares = 0;
    for (std::size_t i = 0; i < captures.size(); ++i) {
        double const height = height_mm(fit.model, captures[i].counts).value_or(0);
        double const residual = fit.residuals_mm.emplace_back(captures[i].ruler_mm - height);
        if (std::binary_search(fit.slipped.begin(), fit.slipped.end(), i))
            continue;
        fit.max_mm = std::max(fit.max_mm, std::abs(residual));
        squares += residual * residual;
    }
    auto const used = captures.size() - fit.slipped.size();
    fit.rms_mm = std::sqrt(squares / static_cast<double>(used));
}

HeightFit describe(Captures captures, Choice choice, HeightFitOptions const& options)
{
    HeightFit fit;
    fit.model = choice.fit.fit.model;
    fit.reason = std::move(choice.reason);
    fit.candidates = std::move(choice.candidates);
    fit.slipped = choice.fit.slipped;
    fit.capture_error_mm = std::sqrt(
        std::max(options.ruler_error_mm * options.ruler_error_mm, choice.fit.variance_mm2()));
    fit.apart_mm = fit.capture_error_mm;
    fit.covariance = choice.fit.fit.unit_covariance * fit.capture_error_mm * fit.capture_error_mm;
    bend_track(captures, options, fit);
    fit.parameters = parameters_with_errors(fit.model, fit.covariance);
    tell_residuals(captures, fit);
    fit.hysteresis = hysteresis_of(captures, fit, options.ruler_error_mm);
    fit.noise_counts = pooled_noise(captures);
    tell_range(captures, fit);
    return fit;
}

} // namespace

std::string_view name_of(HeightModelKind kind)
{
    return kNames[static_cast<std::size_t>(kind)];
}

std::optional<HeightModelKind> parse_height_model_kind(std::string_view name)
{
    auto const found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end())
        return std::nullopt;
    return static_cast<HeightModelKind>(found - kNames.begin());
}

HeightCapture::From direction(std::optional<double> before_mm, double ruler_mm)
{
    constexpr double kMinMove_mm = 1;
    double const rise_mm = before_mm ? ruler_mm - *before_mm : 0;
    return rise_mm > kMinMove_mm ? HeightCapture::From::Below
        : rise_mm < -kMinMove_mm ? HeightCapture::From::Above
                                 : HeightCapture::From::Nowhere;
}

void assign_directions(std::vector<HeightCapture>& captures)
{
    std::optional<double> before_mm;
    for (auto& capture : captures) {
        capture.from = direction(before_mm, capture.ruler_mm);
        before_mm = capture.ruler_mm;
    }
}

double height_error_mm(HeightFit const& fit, double counts)
{
    auto const gradient = height_gradient(fit.model, counts);
    return std::sqrt(std::max(0.0, gradient.dot(fit.covariance * gradient)));
}

Result<HeightFit> fit_height(Captures captures, HeightFitOptions const& options)
{
    TRY(check_captures(captures));
    auto choice = options.kind ? TRY(fit_asked_kind(captures, options))
                               : TRY(choose_model(captures, options));
    return describe(captures, std::move(choice), options);
}

} // namespace tractus::calib
