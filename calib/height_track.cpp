#include "calib/height_track.h"

#include "calib/line_fit.h"
#include "engine/base/check.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tractus::calib {

HeightTrack::Place HeightTrack::first_not_before(Timestamp time) const
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
    while (!unknown_.empty() && newest() - unknown_.front() > memory_)
        unknown_.pop_front();
}

void HeightTrack::add_unknown(Timestamp time)
{
    if (!empty() && time > newest() && (unknown_.empty() || time > unknown_.back()))
        unknown_.push_back(time);
}

void HeightTrack::end_bridge()
{
    while (!unknown_.empty() && (empty() || unknown_.back() > newest()))
        unknown_.pop_back();
}

// True if the sensor gave readings throughout the gap, although their values are not known.
bool HeightTrack::is_bridged(Timestamp from, Timestamp to, Duration max_age) const
{
    if (to - from <= max_age || to - from > kMaxBridged)
        return to - from <= max_age;
    auto last = from;
    for (auto time = std::upper_bound(unknown_.begin(), unknown_.end(), from);
         time != unknown_.end() && *time < to && *time - last <= max_age; ++time)
        last = *time;
    return to - last <= max_age;
}

Timestamp HeightTrack::newest() const
{
    CHECK(!empty());
    return readings_.back().time;
}

// Returns the nearer neighbour's height if the reading is a spike, otherwise its own.
double HeightTrack::without_spike_mm(Place const& reading) const
{
    constexpr double kMinSpike_mm = 1; // Smaller deviations are noise, which the fit smooths.
    // Acceleration of a hand that reverses its movement.
    constexpr double kMaxAcceleration_mm_per_ss = 20000;
    if (reading == readings_.begin() || std::next(reading) == readings_.end())
        return reading->height_mm;
    auto const& before = *std::prev(reading);
    auto const& after = *std::next(reading);
    auto const [low, high] = std::minmax(before.height_mm, after.height_mm);
    double const nearer_mm = std::clamp(reading->height_mm, low, high);
    double const seconds
        = to_seconds(std::max(reading->time - before.time, after.time - reading->time));
    double const most_mm = kMinSpike_mm + kMaxAcceleration_mm_per_ss / 2 * seconds * seconds;
    return std::abs(reading->height_mm - nearer_mm) > most_mm ? nearer_mm : reading->height_mm;
}

std::optional<HeightTrack::LineAt> HeightTrack::fit(Timestamp centre, Timestamp time,
                                                    Duration half_width) const
{
    LineFit sums;
    for (auto reading = first_not_before(centre - half_width);
         reading != readings_.end() && reading->time < centre + half_width; ++reading) {
        double const distance = to_seconds(reading->time - centre) / to_seconds(half_width);
        sums.add(to_seconds(reading->time - time), without_spike_mm(reading),
                 1 - distance * distance);
    }
    auto const line = sums.line();
    return line ? std::optional(LineAt { line->at_zero, line->per_second }) : std::nullopt;
}

// Interpolates linearly between `after` and the reading before it.
double HeightTrack::between_mm(Place const& after, Timestamp time) const
{
    if (after == readings_.begin())
        return without_spike_mm(after);
    auto const before = std::prev(after);
    double const part = to_seconds(time - before->time) / to_seconds(after->time - before->time);
    double const from_mm = without_spike_mm(before);
    return from_mm + part * (without_spike_mm(after) - from_mm);
}

// Returns the line at one side of a gap. If unknown readings fill the gap, it may be long, so the
// fit may use a wider window.
std::optional<HeightTrack::LineAt> HeightTrack::slope_at(Timestamp side, Timestamp gap_begin,
                                                         Timestamp gap_end) const
{
    auto line = fit(side, side);
    auto const unknown = std::upper_bound(unknown_.begin(), unknown_.end(), gap_begin);
    if (unknown == unknown_.end() || *unknown >= gap_end)
        return line;
    for (int widening = 2; !line && widening <= kWidestInGap; ++widening)
        line = fit(side, side, kHalfWidth * widening);
    return line;
}

// Interpolates between `before` and the next reading, which are far apart: by a cubic Hermite
// curve, or a straight line if a side has too few readings for a slope.
double HeightTrack::across_mm(Place const& before, Timestamp time) const
{
    auto const after = std::next(before);
    double const width_s = to_seconds(after->time - before->time);
    double const t = to_seconds(time - before->time) / width_s;
    auto const left = slope_at(before->time, before->time, after->time);
    auto const right = slope_at(after->time, before->time, after->time);
    double const from_mm = left ? left->height_mm : without_spike_mm(before);
    double const to_mm = right ? right->height_mm : without_spike_mm(after);
    if (!left || !right)
        return from_mm + t * (to_mm - from_mm);
    double const u = 1 - t;
    return (1 + 2 * t) * u * u * from_mm + t * t * (3 - 2 * t) * to_mm
        + width_s * t * u * (u * left->mm_per_s - t * right->mm_per_s);
}

std::optional<HeightTrack::Estimate> HeightTrack::at(Timestamp time, Duration max_age) const
{
    auto const after = first_not_before(time);
    bool const has_after = after != readings_.end() && is_bridged(time, after->time, max_age);
    bool const has_before
        = after != readings_.begin() && is_bridged(std::prev(after)->time, time, max_age);

    if (has_after && (has_before || after->time == time)) {
        bool const is_gap
            = has_before && after->time > time && after->time - std::prev(after)->time > kHalfWidth;
        if (is_gap)
            return Estimate { across_mm(std::prev(after), time),
                              TipSample::HeightSource::Interpolated };
        if (auto const line = fit(time, time))
            return Estimate { line->height_mm, TipSample::HeightSource::Interpolated };
        return Estimate { has_before ? between_mm(after, time) : after->height_mm,
                          TipSample::HeightSource::Interpolated };
    }
    if (!has_before && !has_after)
        return std::nullopt;
    auto const nearest = has_before ? std::prev(after) : after;
    auto const reached
        = std::clamp(time, nearest->time - kExtrapolation, nearest->time + kExtrapolation);
    auto const line = fit(nearest->time, reached);
    return Estimate { line ? line->height_mm : nearest->height_mm,
                      TipSample::HeightSource::Extrapolated };
}

std::optional<HeightTrack::Estimate> HeightTrack::at_corner(Timestamp time, Duration max_age) const
{
    constexpr double kNoise_mm = 0.25; // Greatest difference from a narrow fit that noise explains.
    // Greatest difference from the two neighbouring readings that noise explains.
    constexpr double kNoiseOfReadings_mm = 0.4;
    auto estimate = at(time, max_age);
    if (!estimate || estimate->kind != TipSample::HeightSource::Interpolated)
        return estimate;
    auto const line = fit(time, time, kNarrowHalfWidth);
    double const narrow_mm = line ? line->height_mm : between_mm(first_not_before(time), time);
    if (std::abs(narrow_mm - estimate->height_mm) > (line ? kNoise_mm : kNoiseOfReadings_mm))
        estimate->height_mm = narrow_mm;
    return estimate;
}

// Returns the usual spacing of the last readings, ignoring the shortest intervals, since bursts
// bring several readings at once.
Duration HeightTrack::usual_spacing() const
{
    constexpr std::size_t kLast = 8;
    auto const count = std::min(kLast, readings_.size());
    if (count < 2)
        return Duration {};
    auto const first = std::prev(readings_.end(), static_cast<std::ptrdiff_t>(count));
    return (newest() - first->time) / static_cast<std::int64_t>(count - 1);
}

// Returns a reading far enough before another one for a speed that is not mostly noise. It is two
// readings earlier, unless readings are so rare that two of them span an outdated movement.
HeightTrack::Place HeightTrack::earlier_reading_for_speed(Place const& reading) const
{
    constexpr Duration kMinApart = std::chrono::milliseconds(6);
    constexpr Duration kMaxApart = std::chrono::milliseconds(25);
    constexpr int kReadings = 2;
    auto before = reading;
    for (int i = 0; before != readings_.begin(); ++i, --before) {
        bool const is_near = reading->time - before->time < kMinApart;
        bool const is_one_more_near
            = i < kReadings && reading->time - std::prev(before)->time < kMaxApart;
        if (!is_near && !is_one_more_near)
            break;
    }
    return before;
}

double HeightTrack::speed_mm_per_s(Place const& from, Place const& to)
{
    double const seconds = to_seconds(to->time - from->time);
    return seconds > 0 ? (to->height_mm - from->height_mm) / seconds : 0;
}

// Returns the carriage's speed beyond the newest reading: the last speed, or less if the carriage
// was clearly slowing down, for it will continue to do so. Small decelerations are noise in a
// steady movement; extrapolating them would hold back every other tip.
double HeightTrack::newest_speed_mm_per_s() const
{
    constexpr double kFastest_mm_per_s = 600; // A faster reading is a spike or a slip.
    constexpr double kPlainly_mm_per_s = 40;
    auto const last = std::prev(readings_.end());
    auto const middle = earlier_reading_for_speed(last);
    double const speed
        = std::clamp(speed_mm_per_s(middle, last), -kFastest_mm_per_s, kFastest_mm_per_s);
    double const before = speed_mm_per_s(earlier_reading_for_speed(middle), middle);
    // Each speed applies to the middle of its interval: extrapolates from there to the middle of
    // the next interval.
    double const span_s = to_seconds(last->time - middle->time);
    double const ahead = span_s > 0 ? 0.5 + 0.5 * to_seconds(usual_spacing()) / span_s : 1;
    double const next = speed - ahead * (before - speed);
    if (std::abs(before) <= std::abs(speed) + kPlainly_mm_per_s || before * speed <= 0)
        return speed;
    return next * speed > 0 ? next : 0;
}

std::optional<HeightTrack::Estimate> HeightTrack::newest_at(Timestamp time, Duration max_age,
                                                            Duration deliveries) const
{
    constexpr double kLeeway_mm = 0.2; // Margin for noise, by which a fit may exceed the readings.
    if (empty() || time <= newest() || time - newest() > max_age)
        return at(time, max_age); // Times inside a bridged gap are interpolated, too.
    auto const& last = readings_.back();
    auto const reached = std::min(
        time, last.time + std::max({ kExtrapolation, usual_spacing() * 3 / 2, deliveries }));
    double const way_mm = newest_speed_mm_per_s() * to_seconds(reached - last.time);
    auto const line = fit(last.time, reached);
    double const height_mm = line
        ? std::clamp(line->height_mm, last.height_mm + std::min(way_mm, 0.0) - kLeeway_mm,
                     last.height_mm + std::max(way_mm, 0.0) + kLeeway_mm)
        : last.height_mm + way_mm;
    return Estimate { height_mm, TipSample::HeightSource::Extrapolated };
}

} // namespace tractus::calib
