#include "app/calibration/height_plots.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace tractus::calibration {

namespace {

using Captures = std::span<calib::HeightCapture const>;
using From = calib::HeightCapture::From;
using Kind = PlotSeries::Kind;

constexpr int kCurvePoints = 120;
// Half width of the error bands in standard deviations; two cover 95 % of a normal distribution.
constexpr double kBandDeviations = 2;

bool is_slipped(calib::HeightFit const& fit, std::size_t capture)
{
    return std::binary_search(fit.slipped.begin(), fit.slipped.end(), capture);
}

struct Group {
    From from = From::Nowhere;
    PlotTone tone = PlotTone::FromNowhere;
    char const* label = "";
};

constexpr Group kGroups[] { { From::Nowhere, PlotTone::FromNowhere, "first capture" },
                            { From::Below, PlotTone::FromBelow, "going up" },
                            { From::Above, PlotTone::FromAbove, "going down" } };

enum class Labels {
    Shown,
    Hidden, // Captures are not in the legend, as a plot beside this one already lists them.
};

// Adds a point for each capture at the position that `place` returns. Slipped captures are crosses.
template<typename Place>
void add_captures(Plot& plot, calib::HeightFit const& fit, Captures captures, Labels labels,
                  Place const& place)
{
    auto const first_new = plot.series.size();
    PlotSeries slipped { .kind = Kind::Crosses,
                         .tone = PlotTone::Slipped,
                         .label = "slipped, left out" };
    for (auto const& group : kGroups) {
        PlotSeries dots { .kind = Kind::Dots, .tone = group.tone, .label = group.label };
        for (std::size_t i = 0; i < captures.size(); ++i)
            if (captures[i].from == group.from)
                (is_slipped(fit, i) ? slipped : dots).points.push_back(place(i));
        if (!dots.points.empty())
            plot.series.push_back(std::move(dots));
    }
    if (!slipped.points.empty())
        plot.series.push_back(std::move(slipped));
    for (auto i = first_new; labels == Labels::Hidden && i < plot.series.size(); ++i)
        plot.series[i].label.clear();
}

Plot fit_plot(calib::HeightFit const& fit, Captures captures)
{
    Plot plot { .title = fmt::format("Fit: {}", calib::name_of(fit.model)),
                .x_label = "reading, counts",
                .y_label = "height, mm" };
    PlotSeries curve { .kind = Kind::Line, .tone = PlotTone::Model, .label = "model" };
    for (int i = 0; i <= kCurvePoints; ++i) {
        double const counts
            = fit.low_counts + (fit.high_counts - fit.low_counts) * i / kCurvePoints;
        if (auto const height = calib::height_mm(fit.model, counts))
            curve.points.emplace_back(counts, *height);
    }
    plot.series.push_back(std::move(curve));
    add_captures(plot, fit, captures, Labels::Shown,
                 [&](std::size_t i) { return Vec2(captures[i].counts, captures[i].ruler_mm); });
    fit_range(plot, PlotRange::Tight);
    return plot;
}

// Adds two bands of ±2 standard deviations: of the error of a capture, and of the model's own
// error.
void add_bands(Plot& plot, calib::HeightFit const& fit)
{
    double const capture_mm = kBandDeviations * fit.capture_error_mm;
    plot.series.push_back({ .kind = Kind::Band,
                            .tone = PlotTone::Expected,
                            .label = fmt::format("±{:.2g} mm, where 95 % should lie", capture_mm),
                            .points = { { fit.low_mm, -capture_mm }, { fit.high_mm, -capture_mm } },
                            .upper = { { fit.low_mm, capture_mm }, { fit.high_mm, capture_mm } } });
    PlotSeries model { .kind = Kind::Band,
                       .tone = PlotTone::Model,
                       .label = "the model's own error" };
    for (int i = 0; i <= kCurvePoints; ++i) {
        double const counts
            = fit.low_counts + (fit.high_counts - fit.low_counts) * i / kCurvePoints;
        auto const height = calib::height_mm(fit.model, counts);
        if (!height)
            continue;
        double const error_mm = kBandDeviations * calib::height_error_mm(fit, counts);
        model.points.emplace_back(*height, -error_mm);
        model.upper.emplace_back(*height, error_mm);
    }
    plot.series.push_back(std::move(model));
}

Plot residual_plot(calib::HeightFit const& fit, Captures captures)
{
    Plot plot { .title = fmt::format("Residuals: {:.2f} mm RMS, {:.2f} mm at most", fit.rms_mm,
                                     fit.max_mm),
                .x_label = "height, mm",
                .y_label = "ruler less model, mm" };
    add_bands(plot, fit);
    // Larger residuals are drawn at this border: a slip of 20 mm would flatten everything else.
    double border_mm = kBandDeviations * fit.capture_error_mm;
    for (std::size_t i = 0; i < captures.size(); ++i)
        if (!is_slipped(fit, i))
            border_mm = std::max(border_mm, std::abs(fit.residuals_mm[i]));
    border_mm *= 1.4;
    add_captures(plot, fit, captures, Labels::Hidden, [&](std::size_t i) {
        return Vec2(captures[i].ruler_mm, std::clamp(fit.residuals_mm[i], -border_mm, border_mm));
    });
    fit_range(plot, PlotRange::SymmetricY);
    return plot;
}

// Plots by how much the model's height exceeds the ruler's, in order of height. Captures after
// upward and after downward movement have a line each, with their mean.
Plot hysteresis_plot(calib::HeightFit const& fit, Captures captures)
{
    Plot plot { .title = "Up against down: too few captures to tell",
                .x_label = "height, mm",
                .y_label = "model less ruler, mm" };
    if (fit.hysteresis)
        plot.title = fmt::format("Up against down: {:+.2f} ± {:.2f} mm", fit.hysteresis->mm,
                                 fit.hysteresis->standard_error_mm);
    for (auto const& group : kGroups) {
        PlotSeries way { .kind = Kind::Line, .tone = group.tone, .label = group.label };
        double mean_mm = 0;
        for (std::size_t i = 0; i < captures.size(); ++i)
            if (captures[i].from == group.from && !is_slipped(fit, i)) {
                way.points.emplace_back(captures[i].ruler_mm, -fit.residuals_mm[i]);
                mean_mm -= fit.residuals_mm[i];
            }
        if (way.points.empty() || group.from == From::Nowhere)
            continue;
        mean_mm /= static_cast<double>(way.points.size());
        std::sort(way.points.begin(), way.points.end(),
                  [](Vec2 const& a, Vec2 const& b) { return a.x() < b.x(); });
        PlotSeries dots { .kind = Kind::Dots, .tone = group.tone, .points = way.points };
        PlotSeries mean { .kind = Kind::Line,
                          .tone = group.tone,
                          .points = { { fit.low_mm, mean_mm }, { fit.high_mm, mean_mm } } };
        plot.series.insert(plot.series.end(), { std::move(mean), std::move(way), std::move(dots) });
    }
    fit_range(plot, PlotRange::SymmetricY);
    return plot;
}

Plot noise_plot(calib::HeightFit const& fit, Captures captures, std::int32_t full_scale_counts)
{
    Plot plot { .title = fmt::format("Noise at rest: {:.2f} counts", fit.noise_counts),
                .x_label = "reading less its capture's mean, counts",
                .y_label = "readings" };
    double const width = calib::noise_bin_counts(full_scale_counts);
    std::size_t bins = 0;
    double readings = 0;
    for (auto const& capture : captures)
        bins = std::max(bins, capture.scatter.size());
    PlotSeries bars {
        .kind = Kind::Bars, .tone = PlotTone::Measured, .label = "measured", .bar_width = width
    };
    double const middle = (static_cast<double>(bins) - 1) / 2;
    for (std::size_t i = 0; i < bins; ++i)
        bars.points.emplace_back((static_cast<double>(i) - middle) * width, 0);
    for (auto const& capture : captures)
        for (std::size_t i = 0; i < capture.scatter.size(); ++i) {
            bars.points[i + (bins - capture.scatter.size()) / 2].y() += capture.scatter[i];
            readings += capture.scatter[i];
        }
    plot.series.push_back(std::move(bars));
    if (fit.noise_counts > 0.2 * width && bins > 1) {
        PlotSeries normal { .kind = Kind::Line, .tone = PlotTone::Model, .label = "normal" };
        double const reach = (middle + 0.5) * width;
        for (int i = 0; i <= kCurvePoints; ++i) {
            double const x = -reach + 2 * reach * i / kCurvePoints;
            double const z = x / fit.noise_counts;
            normal.points.emplace_back(
                x, readings * width / fit.noise_counts / std::sqrt(2 * kPi) * std::exp(-z * z / 2));
        }
        plot.series.push_back(std::move(normal));
    }
    fit_range(plot, PlotRange::FromZeroY);
    return plot;
}

} // namespace

std::vector<Plot> height_plots(calib::HeightFit const& fit, Captures captures,
                               std::int32_t full_scale_counts)
{
    return { fit_plot(fit, captures), residual_plot(fit, captures), hysteresis_plot(fit, captures),
             noise_plot(fit, captures, full_scale_counts) };
}

} // namespace tractus::calibration
