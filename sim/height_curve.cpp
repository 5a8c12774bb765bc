#include "sim/height_curve.h"
#include "drivers/height_decoders.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <memory>
#include <utility>

namespace tractus::sim {

HeightCurve::HeightCurve(std::vector<Point> points, std::int32_t full_scale)
    : points_(std::move(points))
    , full_scale_(full_scale)
{
}

Result<HeightCurve> HeightCurve::read(drivers::Log const& log)
{
    for (std::size_t device = 0; device < log.devices.size(); ++device) {
        auto const decoder = drivers::make_height_decoder(log.devices[device]);
        if (!decoder)
            continue;
        std::vector<drivers::HeightSample> samples;
        drivers::LogCursor cursor(log);
        while (auto const* const report = TRY(cursor.next()))
            // If a part of a report cannot be decoded, it is missing from the curve.
            if (report->device == device)
                static_cast<void>((*decoder)->decode(report->time, report->bytes, samples));
        std::vector<Point> points;
        for (auto const& sample : samples)
            points.push_back({ .time = Timestamp(sample.time - log.begin()),
                               .fraction = double(sample.counts) / sample.full_scale });
        std::stable_sort(points.begin(), points.end(),
                         [](Point const& a, Point const& b) { return a.time < b.time; });
        if (!points.empty())
            return HeightCurve(std::move(points), (*decoder)->full_scale());
    }
    return fail(Fault::User,
                fmt::format("{} has no heights to play: a height sensor must be among "
                            "its devices",
                            log.name));
}

double HeightCurve::fraction_at(Timestamp time) const
{
    auto const after
        = std::upper_bound(points_.begin(), points_.end(), time,
                           [](Timestamp t, Point const& point) { return t < point.time; });
    if (after == points_.begin())
        return points_.front().fraction;
    if (after == points_.end())
        return points_.back().fraction;
    auto const& before = *std::prev(after);
    double const part = to_seconds(time - before.time) / to_seconds(after->time - before.time);
    return before.fraction + part * (after->fraction - before.fraction);
}

std::int32_t HeightCurve::counts_at(Timestamp time, std::int32_t full_scale) const
{
    return static_cast<std::int32_t>(std::lround(fraction_at(time) * full_scale));
}

} // namespace tractus::sim
