#include "calib/height_model_fit.h"

#include "calib/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus::calib {

namespace {

using Captures = std::span<HeightCapture const>;

struct Line {
    double slope = 0;
    double value_at_zero = 0;
};

// Fits a weighted line through (x, y); no value if all x are equal.
std::optional<Line> fit_line(Eigen::VectorXd const& x, Eigen::VectorXd const& y,
                             Eigen::VectorXd const& weights)
{
    double const sum = weights.sum();
    double const mean_x = weights.dot(x) / sum;
    double const mean_y = weights.dot(y) / sum;
    Eigen::VectorXd const dx = x.array() - mean_x;
    double const spread = weights.dot(dx.cwiseProduct(dx));
    if (!(spread > 1e-12 * (1 + mean_x * mean_x)))
        return std::nullopt;
    double const slope = weights.dot(dx.cwiseProduct(y)) / spread;
    return Line { slope, mean_y - slope * mean_x };
}

struct Columns {
    Eigen::VectorXd counts;
    Eigen::VectorXd heights;
};

Columns columns_of(Captures captures)
{
    auto const size = static_cast<Eigen::Index>(captures.size());
    Columns columns { Eigen::VectorXd(size), Eigen::VectorXd(size) };
    for (Eigen::Index i = 0; i < size; ++i) {
        columns.counts[i] = captures[static_cast<std::size_t>(i)].counts;
        columns.heights[i] = captures[static_cast<std::size_t>(i)].ruler_mm;
    }
    return columns;
}

// Returns heights by the model minus those by the ruler, followed by the weighted doubt_at_ends();
// no value outside the model.
std::optional<Eigen::VectorXd> differences(HeightModel const& model, Captures captures)
{
    // Usual error of a ruler, by which a doubt is weighted.
    constexpr double kWorthOfDoubt_mm = 0.3;
    if (!is_valid(model))
        return std::nullopt;
    auto const doubt = doubt_at_ends(model, span_to_hold(captures));
    if (!doubt)
        return std::nullopt;
    auto const size = static_cast<Eigen::Index>(captures.size());
    Eigen::VectorXd result(size + 1);
    result[size] = *doubt * kWorthOfDoubt_mm;
    for (std::size_t i = 0; i < captures.size(); ++i) {
        auto const height = height_mm(model, captures[i].counts);
        if (!height)
            return std::nullopt;
        result[static_cast<Eigen::Index>(i)] = *height - captures[i].ruler_mm;
    }
    return result;
}

std::optional<double> sum_of_squares(HeightModel const& model, Captures captures)
{
    auto const misfit = differences(model, captures);
    return misfit ? std::optional(misfit->squaredNorm()) : std::nullopt;
}

std::optional<ModelFit> fit_from(HeightModel const& start, Captures captures)
{
    auto const residuals = [&](Eigen::VectorXd const& parameters) {
        return differences(with_parameters(start, parameters), captures);
    };
    auto const fit = fit_least_squares(residuals, parameters_of(start));
    if (!fit)
        return std::nullopt;
    return ModelFit { .model = with_parameters(start, fit->parameters),
                      .sum_of_squares_mm2 = fit->sum_of_squares(),
                      .unit_covariance = fit->unit_covariance };
}

std::optional<ModelFit> better(std::optional<ModelFit> a, std::optional<ModelFit> b)
{
    if (!a || (b && b->sum_of_squares_mm2 < a->sum_of_squares_mm2))
        return b;
    return a;
}

// Returns the best string model with a given offset and a given rise at the lowest capture: the
// remaining parameters are a line from counts to lengths. A difference in length is weighted by the
// difference in height that it causes.
std::optional<StringHeight> string_through(Columns const& columns, double offset_mm,
                                           double min_rise_mm)
{
    double const base_mm = min_rise_mm - columns.heights.minCoeff();
    Eigen::VectorXd const rises = columns.heights.array() + base_mm;
    Eigen::VectorXd const lengths = (rises.array().square() + offset_mm * offset_mm).sqrt();
    Eigen::VectorXd const weights = (lengths.array() / rises.array()).square();
    auto const line = fit_line(columns.counts, lengths, weights);
    if (!line || line->slope == 0)
        return std::nullopt;
    return StringHeight { .mm_per_count = line->slope,
                          .zero_length_mm = line->value_at_zero,
                          .offset_mm = offset_mm,
                          .base_mm = base_mm };
}

// Fits with the spool below. The sum of squares has long valleys, so the search starts from the
// best of several points in them.
std::optional<ModelFit> fit_string_from_below(Captures captures)
{
    constexpr std::size_t kStarts = 3;
    auto const columns = columns_of(captures);
    double const span_mm = columns.heights.maxCoeff() - columns.heights.minCoeff();
    std::vector<std::pair<double, StringHeight>> starts;
    for (double const offset : { 0.08, 0.3, 0.8, 2.0 })
        // The least start, 0.15 of the span, exceeds the tenth of the span by which the law must
        // continue below the captures.
        for (double const rise : { 0.15, 0.3, 0.7, 2.0 })
            if (auto const start = string_through(columns, offset * span_mm, rise * span_mm))
                if (auto const misfit = sum_of_squares(*start, captures))
                    starts.emplace_back(*misfit, *start);
    std::stable_sort(starts.begin(), starts.end(),
                     [](auto const& a, auto const& b) { return a.first < b.first; });
    std::optional<ModelFit> best;
    for (std::size_t i = 0; i < std::min(kStarts, starts.size()); ++i)
        best = better(best, fit_from(starts[i].second, captures));
    return best;
}

// Turns heights upside down, so that a spool above becomes one below.
std::vector<HeightCapture> upside_down(Captures captures)
{
    std::vector<HeightCapture> turned(captures.begin(), captures.end());
    for (auto& capture : turned)
        capture.ruler_mm = -capture.ruler_mm;
    return turned;
}

} // namespace

std::size_t parameter_count(HeightModelKind kind)
{
    switch (kind) {
    case HeightModelKind::Linear:
        return 2;
    case HeightModelKind::String:
        return 4;
    case HeightModelKind::Monotone:
        return 5;
    }
    return 2;
}

std::optional<ModelFit> fit_linear(Captures captures)
{
    auto const columns = columns_of(captures);
    Eigen::VectorXd const weights = Eigen::VectorXd::Ones(columns.counts.size());
    auto const line = fit_line(columns.counts, columns.heights, weights);
    if (!line || line->slope == 0)
        return std::nullopt;
    return fit_from(LinearHeight { .mm_per_count = line->slope,
                                   .zero_counts = -line->value_at_zero / line->slope },
                    captures);
}

std::optional<ModelFit> fit_string(Captures captures)
{
    auto const below = fit_string_from_below(captures);
    auto above = fit_string_from_below(upside_down(captures));
    if (above) {
        auto& model = std::get<StringHeight>(above->model);
        model.spool = StringHeight::Spool::Above;
        model.base_mm = -model.base_mm;
        above->unit_covariance.row(3) *= -1;
        above->unit_covariance.col(3) *= -1;
    }
    return better(below, above);
}

std::optional<ModelFit> fit_monotone(Captures captures, MonotoneKnots const& knots)
{
    std::vector<HeightCapture> sorted(captures.begin(), captures.end());
    std::sort(sorted.begin(), sorted.end(),
              [](auto const& a, auto const& b) { return a.counts < b.counts; });
    MonotoneHeight start;
    for (std::size_t i = 0; i < knots.count; ++i) {
        auto const& capture = sorted[i * (sorted.size() - 1) / (knots.count - 1)];
        if (!start.knots.empty() && capture.counts <= start.knots.back().counts)
            return std::nullopt;
        start.knots.push_back({ capture.counts, capture.ruler_mm });
    }
    if (!is_valid(start))
        return std::nullopt;
    return fit_from(start, captures);
}

HeightSpan span_to_hold(Captures captures)
{
    constexpr double kBeyond = 0.1;
    auto const [low, high]
        = std::minmax_element(captures.begin(), captures.end(),
                              [](auto const& a, auto const& b) { return a.ruler_mm < b.ruler_mm; });
    double const beyond_mm = kBeyond * (high->ruler_mm - low->ruler_mm);
    return { low->ruler_mm - beyond_mm, high->ruler_mm + beyond_mm };
}

std::optional<double> doubt_at_ends(HeightModel const& model, HeightSpan const& span)
{
    // Height of the string's end above the spool, as a share of the span, below which doubt begins.
    constexpr double kClear = 0.06;
    auto const* string = std::get_if<StringHeight>(&model);
    if (!string)
        return 0;
    double const rise_mm = string->spool == StringHeight::Spool::Below
        ? span.low_mm + string->base_mm
        : -span.high_mm - string->base_mm;
    if (!(rise_mm > 0))
        return std::nullopt;
    return std::max(0.0, kClear * (span.high_mm - span.low_mm) / rise_mm - 1);
}

Eigen::VectorXd height_gradient(HeightModel const& model, double counts)
{
    auto const parameters = parameters_of(model);
    auto const& bend = bend_of(model);
    auto const of_bend = static_cast<Eigen::Index>(bend.size());
    auto const at
        = [&](HeightModel const& changed) { return height_mm(changed, counts).value_or(0); };
    Eigen::VectorXd gradient(parameters.size() + of_bend);
    for (Eigen::Index i = 0; i < parameters.size(); ++i) {
        double const step = 1e-6 * std::max(std::abs(parameters[i]), 1e-4);
        Eigen::VectorXd low = parameters;
        Eigen::VectorXd high = parameters;
        low[i] -= step;
        high[i] += step;
        gradient[i]
            = (at(with_parameters(model, high)) - at(with_parameters(model, low))) / (2 * step);
    }
    for (Eigen::Index i = 0; i < of_bend; ++i) {
        constexpr double kStep_counts = 1e-3;
        auto low = bend;
        auto high = bend;
        low[static_cast<std::size_t>(i)].shift_counts -= kStep_counts;
        high[static_cast<std::size_t>(i)].shift_counts += kStep_counts;
        gradient[parameters.size() + i]
            = (at(with_bend(model, high)) - at(with_bend(model, low))) / (2 * kStep_counts);
    }
    return gradient;
}

} // namespace tractus::calib
