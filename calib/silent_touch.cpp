#include "calib/silent_touch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::calib {

namespace {

// Number of remembered intervals, enough to include the longest one of irregular deliveries.
constexpr std::size_t kIntervals = 64;
constexpr std::size_t kFewIntervals = 4;
// Longer intervals between reports are ignored: no tablet that reports continuously has them.
constexpr Duration kLongestInterval = std::chrono::milliseconds(100);
// Reports that arrive at most this far apart belong to one bundle.
constexpr Duration kBundled = std::chrono::milliseconds(1);
constexpr Duration kShortestSilence = std::chrono::milliseconds(10);

} // namespace

// Learns from an interval between reports. A pen that reports only changes has long intervals too,
// but occasionally shows the device's period, which does not change.
void SilentTouch::learn_interval(Duration interval)
{
    if (interval > kLongestInterval || interval < Duration::zero())
        return;
    intervals_.push_back(interval);
    if (intervals_.size() > kIntervals)
        intervals_.pop_front();
    if (intervals_.size() < kFewIntervals)
        return;
    auto sorted = std::vector(intervals_.begin(), intervals_.end());
    std::sort(sorted.begin(), sorted.end());
    // Uses the second value from either end, because the outermost may be due to a delayed report.
    if (sorted[1] < kBundled) {
        silent_after_ = sorted[sorted.size() - 2] * 3 / 2;
    } else {
        period_ = std::min(period_, sorted[sorted.size() / 4]);
        silent_after_ = period_ * 5 / 2;
    }
    silent_after_ = std::max(silent_after_, kShortestSilence);
}

SilentTouch::Silence SilentTouch::hear(drivers::PenSample const& pen, Timestamp arrival)
{
    if (std::exchange(has_arrived_, true))
        learn_interval(arrival - arrival_);
    bool const is_near = !pen_ || (pen.position_mm - pen_->position_mm).norm() <= kRested_mm;
    pen_ = pen.touching ? std::optional(pen) : std::nullopt;
    arrival_ = arrival;
    to_come_.clear();
    passed_over_.clear();
    last_instant_ = pen.time - latency_;
    last_height_mm_.reset();
    moves_until_.reset();
    return is_near ? Silence::Rest : Silence::Loss;
}

void SilentTouch::read(Timestamp instant)
{
    auto const step = instant - last_instant_;
    if (!pen_ || step < kMinSpacing)
        return;
    // If readings are rare, tips are also placed between two readings.
    auto const parts = std::min<std::int64_t>((step + kMaxSpacing - Duration(1)) / kMaxSpacing,
                                              kLookBack / kMaxSpacing);
    auto const from = std::max(last_instant_, instant - kLookBack);
    for (std::int64_t part = 1; part <= parts; ++part)
        to_come_.push_back(from + (instant - from) * part / parts);
    last_instant_ = instant;
}

std::vector<Timestamp> SilentTouch::take_instants(Timestamp now, HeightTrack const& heights,
                                                  Duration max_height_age)
{
    std::vector<Timestamp> instants;
    if (!pen_ || now - arrival_ <= silent_after_)
        return instants;
    if (!last_height_mm_)
        if (auto const height = heights.at(pen_->time - latency_, max_height_age))
            last_height_mm_ = height->height_mm;
    while (!to_come_.empty() && to_come_.front() <= now - latency_) {
        auto const instant = to_come_.front();
        to_come_.pop_front();
        auto const height = heights.newest_at(instant, max_height_age);
        if (!height)
            continue;
        passed_over_.push_back(instant);
        if (std::abs(height->height_mm - last_height_mm_.value_or(height->height_mm)) > kMoved_mm) {
            last_height_mm_ = height->height_mm;
            moves_until_ = instant + kLookBack;
        } else if (!last_height_mm_) {
            last_height_mm_ = height->height_mm;
        }
        if (moves_until_ && instant <= *moves_until_) {
            instants.insert(instants.end(), passed_over_.begin(), passed_over_.end());
            passed_over_.clear();
        }
        while (!passed_over_.empty() && instant - passed_over_.front() > kLookBack)
            passed_over_.pop_front();
    }
    return instants;
}

} // namespace tractus::calib
