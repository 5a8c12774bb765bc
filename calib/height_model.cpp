#include "calib/height_model.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>

namespace tractus::calib {

namespace {

using Knot = MonotoneHeight::Knot;

std::optional<double> if_finite(double value)
{
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

double side_of(StringHeight const& model)
{
    return model.spool == StringHeight::Spool::Below ? 1 : -1;
}

double secant(std::vector<Knot> const& knots, std::size_t i)
{
    return (knots[i + 1].height_mm - knots[i].height_mm) / (knots[i + 1].counts - knots[i].counts);
}

// Returns the slope at an end: that of the parabola through the outer three knots, limited so that
// the curve is monotone and its straight continuation has the same direction.
double end_slope(std::vector<Knot> const& knots, std::size_t outer, std::size_t next)
{
    double const outer_secant = secant(knots, outer);
    if (knots.size() == 2)
        return outer_secant;
    double const outer_width = knots[outer + 1].counts - knots[outer].counts;
    double const next_width = knots[next + 1].counts - knots[next].counts;
    double const ratio
        = ((2 * outer_width + next_width) * outer_secant - outer_width * secant(knots, next))
        / (outer_width + next_width) / outer_secant;
    return outer_secant * std::clamp(ratio, 0.1, 3.0);
}

// Returns the curve's slope at a knot: for inner knots, Brodlie's weighted harmonic mean of the two
// secants, as recommended by Fritsch and Butland.
double slope(std::vector<Knot> const& knots, std::size_t i)
{
    auto const last = knots.size() - 1;
    if (i == 0)
        return end_slope(knots, 0, std::min<std::size_t>(1, last - 1));
    if (i == last)
        return end_slope(knots, last - 1, last > 1 ? last - 2 : 0);
    double const before = knots[i].counts - knots[i - 1].counts;
    double const after = knots[i + 1].counts - knots[i].counts;
    double const part = (before + 2 * after) / (3 * (before + after));
    double const s1 = secant(knots, i - 1);
    double const s2 = secant(knots, i);
    return s1 * s2 / (part * s2 + (1 - part) * s1);
}

// Evaluates the cubic Hermite curve between knots i and i + 1.
double between(std::vector<Knot> const& knots, std::size_t i, double counts)
{
    double const width = knots[i + 1].counts - knots[i].counts;
    double const t = (counts - knots[i].counts) / width;
    double const u = 1 - t;
    return (1 + 2 * t) * u * u * knots[i].height_mm + t * t * (3 - 2 * t) * knots[i + 1].height_mm
        + width * t * u * (u * slope(knots, i) - t * slope(knots, i + 1));
}

// True if a bend is gentle enough for each height to have one reading.
bool bend_is_valid(TrackBend const& bend)
{
    constexpr double kGreatestSlope = 0.3;
    for (std::size_t i = 0; i < bend.size(); ++i)
        if (!std::isfinite(bend[i].counts) || !std::isfinite(bend[i].shift_counts)
            || (i > 0
                && !(bend[i - 1].counts < bend[i].counts
                     && std::abs(bend[i].shift_counts - bend[i - 1].shift_counts)
                         <= kGreatestSlope * (bend[i].counts - bend[i - 1].counts))))
            return false;
    return true;
}

// Returns the reading of a bent track where a straight one would read `straight`. Inverts
// straightened() by iteration, which converges because the bend is gentle.
double bent(TrackBend const& bend, double straight)
{
    constexpr int kMaxSteps = 60;
    double counts = straight;
    for (int step = 0; step < kMaxSteps && !bend.empty(); ++step) {
        double const next = counts + straight - straightened(bend, counts);
        if (next == counts)
            break;
        counts = next;
    }
    return counts;
}

double bend_slope(TrackBend const& bend, std::size_t i)
{
    if (i == 0 || i + 1 == bend.size())
        return 0; // Beyond the outer knots the shift is constant.
    return (bend[i + 1].shift_counts - bend[i - 1].shift_counts)
        / (bend[i + 1].counts - bend[i - 1].counts);
}

std::optional<double> to_height(LinearHeight const& model, double counts)
{
    return if_finite(model.mm_per_count * (straightened(model.bend, counts) - model.zero_counts));
}

std::optional<double> to_height(StringHeight const& model, double counts)
{
    double const length_mm
        = model.mm_per_count * straightened(model.bend, counts) + model.zero_length_mm;
    if (!(length_mm >= model.offset_mm))
        return std::nullopt;
    // The product (L - offset)(L + offset) keeps its precision when L is close to the offset.
    double const rise_mm = std::sqrt((length_mm - model.offset_mm) * (length_mm + model.offset_mm));
    return if_finite(side_of(model) * rise_mm - model.base_mm);
}

std::optional<double> to_height(MonotoneHeight const& model, double counts)
{
    auto const& knots = model.knots;
    if (!std::isfinite(counts))
        return std::nullopt;
    auto const after
        = std::upper_bound(knots.begin(), knots.end(), counts,
                           [](double value, Knot const& knot) { return value < knot.counts; });
    if (after == knots.begin())
        return if_finite(knots.front().height_mm
                         + slope(knots, 0) * (counts - knots.front().counts));
    if (after == knots.end())
        return if_finite(knots.back().height_mm
                         + slope(knots, knots.size() - 1) * (counts - knots.back().counts));
    return if_finite(between(knots, static_cast<std::size_t>(after - knots.begin()) - 1, counts));
}

std::optional<double> to_counts(LinearHeight const& model, double height_mm)
{
    return if_finite(bent(model.bend, height_mm / model.mm_per_count + model.zero_counts));
}

std::optional<double> to_counts(StringHeight const& model, double height_mm)
{
    double const rise_mm = side_of(model) * (height_mm + model.base_mm);
    if (!(rise_mm >= 0))
        return std::nullopt;
    double const length_mm = std::hypot(rise_mm, model.offset_mm);
    return if_finite(bent(model.bend, (length_mm - model.zero_length_mm) / model.mm_per_count));
}

// Finds the reading between knots i and i + 1 by bisection, since the curve is monotone.
double solve_between(std::vector<Knot> const& knots, std::size_t i, double height_mm)
{
    bool const rises = knots[i].height_mm < knots[i + 1].height_mm;
    double low = knots[i].counts;
    double high = knots[i + 1].counts;
    for (int step = 0; step < 60; ++step) {
        double const middle = (low + high) / 2;
        if ((between(knots, i, middle) < height_mm) == rises)
            low = middle;
        else
            high = middle;
    }
    return (low + high) / 2;
}

std::optional<double> to_counts(MonotoneHeight const& model, double height_mm)
{
    auto const& knots = model.knots;
    if (!std::isfinite(height_mm))
        return std::nullopt;
    bool const rises = knots.front().height_mm < knots.back().height_mm;
    auto const is_before = [&](double a, double b) {
        return rises ? a < b : a > b;
    }; // True if height `a` comes before `b` in the order of the knots.
    if (is_before(height_mm, knots.front().height_mm))
        return if_finite(knots.front().counts
                         + (height_mm - knots.front().height_mm) / slope(knots, 0));
    if (!is_before(height_mm, knots.back().height_mm))
        return if_finite(knots.back().counts
                         + (height_mm - knots.back().height_mm) / slope(knots, knots.size() - 1));
    std::size_t i = 0;
    while (!is_before(height_mm, knots[i + 1].height_mm))
        ++i;
    return solve_between(knots, i, height_mm);
}

bool numbers_are_valid(LinearHeight const& model)
{
    return model.mm_per_count != 0 && bend_is_valid(model.bend);
}

bool numbers_are_valid(StringHeight const& model)
{
    return model.mm_per_count != 0 && model.offset_mm >= 0 && bend_is_valid(model.bend);
}

bool numbers_are_valid(MonotoneHeight const& model)
{
    auto const& knots = model.knots;
    if (knots.size() < 2)
        return false;
    bool const rises = knots.front().height_mm < knots.back().height_mm;
    for (std::size_t i = 1; i < knots.size(); ++i)
        if (!(knots[i - 1].counts < knots[i].counts)
            || !(rises ? knots[i - 1].height_mm < knots[i].height_mm
                       : knots[i - 1].height_mm > knots[i].height_mm))
            return false;
    return true;
}

void raise(LinearHeight& model, double rise_mm)
{
    model.zero_counts -= rise_mm / model.mm_per_count;
}

void raise(StringHeight& model, double rise_mm)
{
    model.base_mm -= rise_mm;
}

void raise(MonotoneHeight& model, double rise_mm)
{
    for (auto& knot : model.knots)
        knot.height_mm += rise_mm;
}

void shift(LinearHeight& model, double shift_counts)
{
    model.zero_counts += shift_counts;
}

void shift(StringHeight& model, double shift_counts)
{
    model.zero_length_mm -= shift_counts * model.mm_per_count;
}

void shift(MonotoneHeight& model, double shift_counts)
{
    for (auto& knot : model.knots)
        knot.counts += shift_counts;
}

// Returns the members that a fit may change, in the order of parameters_of().
std::vector<double*> members(LinearHeight& model)
{
    return { &model.mm_per_count, &model.zero_counts };
}

std::vector<double*> members(StringHeight& model)
{
    return { &model.mm_per_count, &model.zero_length_mm, &model.offset_mm, &model.base_mm };
}

std::vector<double*> members(MonotoneHeight& model)
{
    std::vector<double*> heights;
    for (auto& knot : model.knots)
        heights.push_back(&knot.height_mm);
    return heights;
}

std::vector<double*> members_of(HeightModel& model)
{
    return std::visit([](auto& kind) { return members(kind); }, model);
}

} // namespace

std::string_view name_of(HeightModel const& model)
{
    static constexpr std::string_view kNames[] { "linear", "string", "monotone" };
    return kNames[model.index()];
}

bool is_valid(HeightModel const& model)
{
    return parameters_of(model).allFinite()
        && std::visit([](auto const& kind) { return numbers_are_valid(kind); }, model);
}

std::optional<double> height_mm(HeightModel const& model, double counts)
{
    return std::visit([&](auto const& kind) { return to_height(kind, counts); }, model);
}

std::optional<double> counts_at_height(HeightModel const& model, double height_mm)
{
    return std::visit([&](auto const& kind) { return to_counts(kind, height_mm); }, model);
}

std::optional<double> mm_per_count_at(HeightModel const& model, double counts)
{
    constexpr double kStep_counts = 0.5;
    auto const below = height_mm(model, counts - kStep_counts);
    auto const here = height_mm(model, counts);
    auto const above = height_mm(model, counts + kStep_counts);
    if (below && above)
        return (*above - *below) / (2 * kStep_counts);
    if (here
        && (below || above)) // At the string's shortest length, one of the two values is missing.
        return (above ? *above - *here : *here - *below) / kStep_counts;
    return std::nullopt;
}

double straightened(TrackBend const& bend, double counts)
{
    if (bend.empty() || !std::isfinite(counts))
        return counts;
    if (counts <= bend.front().counts)
        return counts + bend.front().shift_counts;
    if (counts >= bend.back().counts)
        return counts + bend.back().shift_counts;
    auto const after
        = std::upper_bound(bend.begin(), bend.end(), counts,
                           [](double value, TrackKnot const& knot) { return value < knot.counts; });
    auto const i = static_cast<std::size_t>(after - bend.begin()) - 1;
    double const width = bend[i + 1].counts - bend[i].counts;
    double const t = (counts - bend[i].counts) / width;
    double const u = 1 - t;
    return counts + (1 + 2 * t) * u * u * bend[i].shift_counts
        + t * t * (3 - 2 * t) * bend[i + 1].shift_counts
        + width * t * u * (u * bend_slope(bend, i) - t * bend_slope(bend, i + 1));
}

HeightModel raised(HeightModel model, double rise_mm)
{
    std::visit([&](auto& kind) { raise(kind, rise_mm); }, model);
    return model;
}

HeightModel shifted(HeightModel model, double shift_counts)
{
    std::visit([&](auto& kind) { shift(kind, shift_counts); }, model);
    return model;
}

Eigen::VectorXd parameters_of(HeightModel const& model)
{
    auto copy = model;
    auto const places = members_of(copy);
    Eigen::VectorXd parameters(static_cast<Eigen::Index>(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i)
        parameters[static_cast<Eigen::Index>(i)] = *places[i];
    return parameters;
}

HeightModel with_parameters(HeightModel model, Eigen::VectorXd const& parameters)
{
    auto const places = members_of(model);
    CHECK(static_cast<Eigen::Index>(places.size()) == parameters.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        *places[i] = parameters[static_cast<Eigen::Index>(i)];
    return model;
}

TrackBend const& bend_of(HeightModel const& model)
{
    static TrackBend const straight;
    if (auto const* line = std::get_if<LinearHeight>(&model))
        return line->bend;
    if (auto const* string = std::get_if<StringHeight>(&model))
        return string->bend;
    return straight;
}

HeightModel with_bend(HeightModel model, TrackBend bend)
{
    if (auto* line = std::get_if<LinearHeight>(&model))
        line->bend = std::move(bend);
    else if (auto* string = std::get_if<StringHeight>(&model))
        string->bend = std::move(bend);
    return model;
}

} // namespace tractus::calib
