#include "calib/height_track.h"

#include "engine/base/check.h"

#include <algorithm>

namespace tractus {

// Sums of a weighted fit of a line, about the instant at which it is asked.
class LineFit {
public:
    void add(double seconds, double value, double weight)
    {
        weights_ += weight;
        times_ += weight * seconds;
        squares_ += weight * seconds * seconds;
        values_ += weight * value;
        products_ += weight * seconds * value;
        ++count_;
    }

    // The line's value at zero seconds.
    std::optional<double> at_zero() const
    {
        // The weighted variance of the times: nothing to fit a slope to where it is tiny.
        constexpr double kLeastSpread_s = 1e-3;
        constexpr int kFewestReadings = 4;
        double const determinant = weights_ * squares_ - times_ * times_;
        if (count_ < kFewestReadings
            || !(determinant > weights_ * weights_ * kLeastSpread_s * kLeastSpread_s))
            return std::nullopt;
        return (squares_ * values_ - times_ * products_) / determinant;
    }

private:
    double weights_ = 0;
    double times_ = 0;
    double squares_ = 0;
    double values_ = 0;
    double products_ = 0;
    int count_ = 0;
};

std::deque<HeightTrack::Reading>::const_iterator HeightTrack::first_not_before(Timestamp time) const
{
    return std::lower_bound(readings_.begin(), readings_.end(), time,
                            [](Reading const& reading, Timestamp t) { return reading.time < t; });
}

void HeightTrack::add(Timestamp time, double height_mm)
{
    if (readings_.empty() || readings_.back().time < time) {
        readings_.push_back({ time, height_mm });
    } else if (newest() - time <= memory_) {
        auto const after = std::upper_bound(
            readings_.cbegin(), readings_.cend(), time,
            [](Timestamp t, Reading const& reading) { return t < reading.time; });
        bool const repeated = after != readings_.cbegin() && std::prev(after)->time == time
            && std::prev(after)->height_mm == height_mm;
        if (!repeated)
            readings_.insert(after, { time, height_mm });
    }
    while (newest() - readings_.front().time > memory_)
        readings_.pop_front();
}

Timestamp HeightTrack::newest() const
{
    CHECK(!empty());
    return readings_.back().time;
}

std::optional<double> HeightTrack::fit(Timestamp centre, Timestamp time) const
{
    LineFit line;
    for (auto reading = first_not_before(centre - kHalfWidth);
         reading != readings_.end() && reading->time < centre + kHalfWidth; ++reading) {
        double const distance = to_seconds(reading->time - centre) / to_seconds(kHalfWidth);
        line.add(to_seconds(reading->time - time), reading->height_mm, 1 - distance * distance);
    }
    return line.at_zero();
}

std::optional<HeightTrack::Estimate> HeightTrack::at(Timestamp time, Duration max_age) const
{
    auto const after = first_not_before(time);
    bool const has_after = after != readings_.end() && after->time - time <= max_age;
    bool const has_before = after != readings_.begin() && time - std::prev(after)->time <= max_age;

    if (has_after && (has_before || after->time == time)) {
        if (auto const height = fit(time, time))
            return Estimate { *height, TipSample::HeightSource::Interpolated };
        if (!has_before)
            return Estimate { after->height_mm, TipSample::HeightSource::Interpolated };
        auto const before = std::prev(after);
        double const part
            = to_seconds(time - before->time) / to_seconds(after->time - before->time);
        return Estimate { before->height_mm + part * (after->height_mm - before->height_mm),
                          TipSample::HeightSource::Interpolated };
    }
    if (!has_before && !has_after)
        return std::nullopt;
    auto const nearest = has_before ? std::prev(after) : after;
    return Estimate { fit(nearest->time, time).value_or(nearest->height_mm),
                      TipSample::HeightSource::Extrapolated };
}

} // namespace tractus
