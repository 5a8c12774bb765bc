#include "drivers/sensors/clock_map.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace tractus::drivers {

namespace {

constexpr std::int64_t kWindowUs = 500'000;
// Shortest time for a fit; over shorter times the slope would be noise.
constexpr std::int64_t kShortestFitUs = 1'000'000;
constexpr std::int64_t kNewClockUs = 500'000;
// Greatest slope of the line, in nanoseconds of delay per microsecond: a clock that is wrong by
// more than 0.5 % is considered broken.
constexpr double kMaxSlope = 5;

std::int64_t to_us(Duration duration)
{
    return duration.count() / 1000;
}

// Extends a wrapping 32-bit value to the 64-bit value nearest to `expected`.
std::int64_t unwrap(std::uint32_t value, std::int64_t expected)
{
    auto const difference = value - static_cast<std::uint32_t>(expected);
    return expected + static_cast<std::int32_t>(difference);
}

// True if b lies on or above the line from a to c.
template<typename Point> bool is_above_chord(Point const& a, Point const& b, Point const& c)
{
    auto const run = [&](Point const& point) { return double(point.sent_us - a.sent_us); };
    auto const rise = [&](Point const& point) { return double(point.delay_ns - a.delay_ns); };
    return rise(b) * run(c) >= rise(c) * run(b);
}

} // namespace

bool ClockMap::add(std::uint32_t device_us, Timestamp arrival, Order order)
{
    if (is_empty_ || !advance(device_us, arrival, order)) {
        bool const is_first = is_empty_;
        begin(device_us, arrival);
        return is_first;
    }
    Point const point { .sent_us = last_us_,
                        .delay_ns = (arrival - first_arrival_).count() - last_us_ * 1000 };
    bool const is_next_window = last_us_ >= window_end_us_;
    if (is_next_window) {
        if (count_ == kWindows)
            std::move(lowest_.begin() + 1, lowest_.end(), lowest_.begin());
        else
            ++count_;
        window_end_us_ = last_us_ + kWindowUs;
        lowest_[count_ - 1] = point;
    } else if (above_line(point) < above_line(lowest_[count_ - 1])) {
        lowest_[count_ - 1] = point;
    }
    if (is_next_window || above_line(point) < 0)
        fit();
    return true;
}

Timestamp ClockMap::host_time(std::uint32_t device_us) const
{
    CHECK(!is_empty_);
    auto const since_us = unwrap(device_us - first_us_, last_us_);
    auto const delay_ns = std::llround(offset_ns_ + slope_ * double(since_us));
    return first_arrival_ + Duration(since_us * 1000 + delay_ns);
}

void ClockMap::begin(std::uint32_t device_us, Timestamp arrival)
{
    *this = {};
    is_empty_ = false;
    first_arrival_ = last_arrival_ = arrival;
    first_us_ = device_us;
    window_end_us_ = kWindowUs;
    count_ = 1; // The first message is the origin of both coordinates.
}

// Advances last_us_ to `device_us`. Returns false if that time can only come from a restarted
// clock.
bool ClockMap::advance(std::uint32_t device_us, Timestamp arrival, Order order)
{
    auto const since_us = device_us - first_us_;
    auto const expected_us = last_us_ + to_us(arrival - last_arrival_);
    auto next_us = unwrap(since_us, expected_us);
    if (order == Order::Follows) // The order is known, so any delay is accepted.
        next_us = unwrap(since_us, last_us_);
    else if (std::abs(next_us - expected_us) > kNewClockUs)
        return false;
    if (next_us <= last_us_)
        return false;
    last_us_ = next_us;
    last_arrival_ = arrival;
    return true;
}

double ClockMap::above_line(Point const& point) const
{
    return double(point.delay_ns) - (offset_ns_ + slope_ * double(point.sent_us));
}

// Fits the line below the points: the edge of their lower convex hull that spans their mean time.
// Of all lines below the points, it has the least sum of distances to them (Moon, Skelly and
// Towsley 1999, section IV).
void ClockMap::fit()
{
    auto const points = std::span(lowest_).first(count_);
    std::array<Point, kWindows> hull {};
    std::size_t corners = 0;
    double sum_us = 0;
    for (auto const& point : points) {
        while (corners >= 2 && is_above_chord(hull[corners - 2], hull[corners - 1], point))
            --corners;
        hull[corners++] = point;
        sum_us += double(point.sent_us);
    }
    slope_ = 0;
    if (points.back().sent_us - points.front().sent_us >= kShortestFitUs) {
        double const mean_us = sum_us / double(count_);
        std::size_t right = 1;
        while (right + 1 < corners && double(hull[right].sent_us) < mean_us)
            ++right;
        auto const& a = hull[right - 1];
        auto const& b = hull[right];
        slope_ = std::clamp(double(b.delay_ns - a.delay_ns) / double(b.sent_us - a.sent_us),
                            -kMaxSlope, kMaxSlope);
    }
    offset_ns_ = std::numeric_limits<double>::max();
    for (auto const& point : points)
        offset_ns_ = std::min(offset_ns_, double(point.delay_ns) - slope_ * double(point.sent_us));
}

} // namespace tractus::drivers
