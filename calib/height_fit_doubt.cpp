#include "calib/height_fit_doubt.h"

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

constexpr double kLeastTravel_mm = 100;
constexpr double kMostErrors = 3;             // Limit in errors of the ruler.
constexpr std::size_t kLeastFreedom = 2;      // Captures that confirm a law.
constexpr std::size_t kFreedomAfterSlips = 3; // Captures that confirm it where others do not.
constexpr std::size_t kMostForPairs = 20;     // Captures; beyond, pairs take too long to try.

// The variance of a capture, as the simpler law of those that fit tells it.
std::optional<double> variance_mm2(Captures captures)
{
    std::optional<double> least;
    for (auto const kind : { HeightModelKind::Linear, HeightModelKind::String }) {
        auto const parameters = parameter_count(kind);
        if (captures.size() < parameters + kLeastFreedom)
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

// Captures that are left out, and how well the rest fits then.
struct LeftOut {
    std::vector<std::size_t> set {}; // Rising.
    double variance_mm2 = std::numeric_limits<double>::infinity();
};

// Finds, of all pairs, the one without which the rest fits best: two that are swapped hide each
// other.
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

// One more than before, the one whose absence does most.
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
    double const most_variance_mm2 = std::pow(kMostErrors * error_mm, 2);
    auto left_out = one_more(captures, {});
    if (left_out.variance_mm2 > most_variance_mm2 && captures.size() <= kMostForPairs)
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
    if (travel_mm >= kLeastTravel_mm)
        return std::nullopt;
    return HeightFitDoubt { fmt::format(
        "the heights span only {:g} mm: were those centimetres? give millimetres, over most of the "
        "travel",
        travel_mm) };
}

} // namespace

std::optional<HeightFitDoubt> doubt_about(HeightFit const& fit, Captures captures,
                                          HeightFitOptions const& options)
{
    if (auto const doubt = doubt_about_travel(captures))
        return doubt;
    auto const used = captures.size() - fit.slipped.size();
    auto const parameters = static_cast<std::size_t>(parameters_of(fit.model).size());
    double const error_mm
        = error_beside_bend_mm(captures, options.ruler_error_mm, options.linearity_percent);
    if (fit.apart_mm > kMostErrors * error_mm) {
        auto const set = disagreeing(captures, error_mm);
        auto const errors = fit.apart_mm / options.ruler_error_mm;
        if (set.empty())
            return HeightFitDoubt { fmt::format(
                "the captures lie {:.1f} mm beside the best model, {:.0f} times the ruler's error, "
                "and none stands out: check what was typed, then the string and its spool",
                fit.apart_mm, errors) };
        return HeightFitDoubt {
            fmt::format("{} {} with the others, which are {:.1f} mm beside any model together with "
                        "{}: measure {} again",
                        listed(captures, set), set.size() > 1 ? "disagree" : "disagrees",
                        fit.apart_mm, set.size() > 1 ? "them" : "it",
                        set.size() > 1 ? "them" : "it"),
            set
        };
    }
    if (!fit.slipped.empty() && used < parameters + kFreedomAfterSlips)
        return HeightFitDoubt {
            fmt::format("{} {} with the others, which are too few to tell who is right: measure "
                        "{} again",
                        listed(captures, fit.slipped),
                        fit.slipped.size() > 1 ? "disagree" : "disagrees",
                        fit.slipped.size() > 1 ? "them" : "it"),
            fit.slipped
        };
    return std::nullopt;
}

} // namespace tractus::calib
