#include "calib/height_fit_doubt.h"

#include "calib/height_fit_range.h"
#include "calib/height_model_fit.h"
#include "calib/track_bend_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <limits>

namespace tractus::calib {

namespace {

using Captures = std::span<HeightCapture const>;

constexpr double kMinTravel_mm = 100;
constexpr double kMaxErrors = 3; // Greatest acceptable deviation from the law, in ruler errors.
constexpr std::size_t kMinFreedom = 2; // Surplus captures needed to confirm a law.
// Surplus captures needed to confirm a law after some were left out.
constexpr std::size_t kFreedomAfterSlips = 3;
// Greatest number of captures for which all pairs are tried; more would take too long.
constexpr std::size_t kMaxForPairs = 20;

// Returns the variance of a capture about the line or string, whichever fits better.
std::optional<double> variance_mm2(Captures captures)
{
    std::optional<double> least;
    for (auto const kind : { HeightModelKind::Linear, HeightModelKind::String }) {
        auto const parameters = parameter_count(kind);
        if (captures.size() < parameters + kMinFreedom)
            continue;
        auto const fit
            = kind == HeightModelKind::Linear ? fit_linear(captures) : fit_string(captures);
        if (!fit)
            continue;
        double const variance
            = fit->sum_of_squares_mm2 / static_cast<double>(captures.size() - parameters);
        least = std::min(least.value_or(variance), variance);
    }
    return least;
}

// Captures that are left out, and how well the rest fits without them.
struct LeftOut {
    std::vector<std::size_t> set {}; // Indices of the captures left out, in rising order.
    double variance_mm2 = std::numeric_limits<double>::infinity();
};

// Returns the pair of captures without which the rest fits best, found by trying all pairs. Swapped
// captures must be left out together, since each hides the other.
LeftOut best_pair(Captures captures)
{
    LeftOut best;
    for (std::size_t i = 0; i < captures.size(); ++i)
        for (auto j = i + 1; j < captures.size(); ++j)
            if (auto const variance = variance_mm2(captures_without(captures, std::array { i, j }));
                variance && *variance < best.variance_mm2)
                best = { { i, j }, *variance };
    return best;
}

// Leaves out one more capture, the one whose absence improves the fit most.
LeftOut one_more(Captures captures, LeftOut const& before)
{
    LeftOut best;
    for (std::size_t i = 0; i < captures.size(); ++i) {
        auto set = before.set;
        if (std::binary_search(set.begin(), set.end(), i))
            continue;
        set.insert(std::upper_bound(set.begin(), set.end(), i), i);
        if (auto const variance = variance_mm2(captures_without(captures, set));
            variance && *variance < best.variance_mm2)
            best = { set, *variance };
    }
    return best;
}

std::vector<std::size_t> disagreeing(Captures captures, double error_mm)
{
    double const most_variance_mm2 = std::pow(kMaxErrors * error_mm, 2);
    auto left_out = one_more(captures, {});
    if (left_out.variance_mm2 > most_variance_mm2 && captures.size() <= kMaxForPairs)
        left_out = best_pair(captures);
    while (left_out.variance_mm2 > most_variance_mm2 && std::isfinite(left_out.variance_mm2)
           && 3 * (left_out.set.size() + 1) <= captures.size())
        left_out = one_more(captures, left_out);
    return left_out.variance_mm2 <= most_variance_mm2 ? left_out.set : std::vector<std::size_t>();
}

std::string listed(Captures captures, std::vector<std::size_t> const& some)
{
    std::vector<std::string> names;
    for (auto const i : some)
        names.push_back(fmt::format("{} ({:g} mm)", i + 1, captures[i].ruler_mm));
    return fmt::format("capture{} {}", some.size() > 1 ? "s" : "", fmt::join(names, ", "));
}

std::optional<HeightFitDoubt> doubt_about_travel(Captures captures)
{
    auto const [low, high]
        = std::minmax_element(captures.begin(), captures.end(),
                              [](auto const& a, auto const& b) { return a.ruler_mm < b.ruler_mm; });
    double const travel_mm = high->ruler_mm - low->ruler_mm;
    if (travel_mm >= kMinTravel_mm)
        return std::nullopt;
    return HeightFitDoubt { fmt::format(
        "the heights span only {:g} mm: were those centimetres? give millimetres, over most of the "
        "travel",
        travel_mm) };
}

// True if captures are farther from their law than a ruler read with the stated error allows.
bool is_apart(HeightFit const& fit, Captures captures, HeightFitOptions const& options)
{
    return fit.apart_mm > kMaxErrors
        * error_beside_bend_mm(captures, options.ruler_error_mm, options.linearity_percent);
}

// Returns the least linearity on usual data sheets that makes all captures agree, if it is more
// than the given one.
std::optional<double> linearity_that_explains_percent(Captures captures,
                                                      HeightFitOptions const& options)
{
    for (double const percent : { 0.5, 1.0, 2.0 }) {
        if (percent <= options.linearity_percent)
            continue;
        auto bent = options;
        bent.linearity_percent = percent;
        auto const fit = fit_height(captures, bent);
        if (fit && fit->slipped.empty() && !is_apart(*fit, captures, bent)
            && check_range(*fit, captures, bent))
            return percent;
    }
    return std::nullopt;
}

// Returns the end of a sentence that offers a cause other than wrong captures; empty if there is
// none.
std::string advice_on_track(Captures captures, HeightFitOptions const& options)
{
    auto const percent = linearity_that_explains_percent(captures, options);
    if (!percent)
        return {};
    return fmt::format("; if all were measured right, the potentiometer's track is not straight or "
                       "its converter loads it: then use --linearity {:g}",
                       *percent);
}

HeightFitDoubt doubt_about_law(HeightFit const& fit, Captures captures,
                               HeightFitOptions const& options)
{
    auto const set = disagreeing(
        captures,
        error_beside_bend_mm(captures, options.ruler_error_mm, options.linearity_percent));
    if (set.empty())
        return { fmt::format("the captures lie {:.1f} mm beside the best model, {:.0f} times the "
                             "ruler's error, and none stands out: check what was typed, then the "
                             "string and its spool",
                             fit.apart_mm, fit.apart_mm / options.ruler_error_mm) };
    auto const* const them = set.size() > 1 ? "them" : "it";
    return { fmt::format(
                 "{} {} with the others, which are {:.1f} mm beside any model together with "
                 "{}: measure {} again",
                 listed(captures, set), set.size() > 1 ? "disagree" : "disagrees", fit.apart_mm,
                 them, them),
             set };
}

HeightFitDoubt doubt_about_slips(HeightFit const& fit, Captures captures)
{
    bool const are_many = fit.slipped.size() > 1;
    return { fmt::format(
                 "{} {} with the others, which are too few to tell who is right: measure {} "
                 "again",
                 listed(captures, fit.slipped), are_many ? "disagree" : "disagrees",
                 are_many ? "them" : "it"),
             fit.slipped };
}

} // namespace

std::optional<HeightFitDoubt> doubt_about(HeightFit const& fit, Captures captures,
                                          HeightFitOptions const& options)
{
    if (auto const doubt = doubt_about_travel(captures))
        return doubt;
    auto const used = captures.size() - fit.slipped.size();
    auto const parameters = static_cast<std::size_t>(parameters_of(fit.model).size());
    std::optional<HeightFitDoubt> doubt;
    if (is_apart(fit, captures, options))
        doubt = doubt_about_law(fit, captures, options);
    else if (!fit.slipped.empty() && used < parameters + kFreedomAfterSlips)
        doubt = doubt_about_slips(fit, captures);
    if (doubt)
        doubt->reason += advice_on_track(captures, options);
    return doubt;
}

} // namespace tractus::calib
