#include "app/calibration/plot.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <limits>

namespace tractus::calibration {

void fit_range(Plot& plot, PlotRange range)
{
    constexpr double kMargin = 0.06;
    constexpr double kMin = 1e-6;
    plot.low = Vec2::Constant(std::numeric_limits<double>::infinity());
    plot.high = -plot.low;
    for (auto const& series : plot.series)
        for (auto const* points : { &series.points, &series.upper })
            for (auto const& point : *points) {
                Vec2 const reach(series.bar_width / 2, 0);
                plot.low = plot.low.cwiseMin(point - reach);
                plot.high = plot.high.cwiseMax(point + reach);
            }
    if (!(plot.low.array() <= plot.high.array()).all())
        plot.low = plot.high = Vec2::Zero();
    if (range == PlotRange::SymmetricY) {
        plot.high.y() = std::max(plot.high.y(), -plot.low.y());
        plot.low.y() = -plot.high.y();
    } else if (range == PlotRange::FromZeroY) {
        plot.low.y() = 0;
    }
    Vec2 const margin = (kMargin * (plot.high - plot.low)).cwiseMax(kMin);
    plot.low -= margin;
    plot.high += margin;
    if (range == PlotRange::FromZeroY)
        plot.low.y() = 0;
}

std::vector<double> ticks_between(double low, double high, int count)
{
    double const rough = (high - low) / count;
    double const power = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * power;
    for (double const factor : { 1.0, 2.0, 5.0 })
        if (factor * power >= rough) {
            step = factor * power;
            break;
        }
    std::vector<double> ticks;
    for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i)
        ticks.push_back(i * step);
    return ticks;
}

std::string tick_text(double value)
{
    return fmt::format("{:.6g}", std::abs(value) < 1e-12 ? 0 : value);
}

} // namespace tractus::calibration
