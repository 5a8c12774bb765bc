#include "calib/even_times.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace tractus::calib {

namespace {

constexpr std::int64_t kMemory_ns = 8'000'000'000;
constexpr std::int64_t kLongestLearning_ns = 4'000'000'000;
constexpr std::size_t kFewestSamples = 32;
constexpr std::size_t kFewestBursts = 8;
// At least one sample in this many must arrive in a burst for bursts to be assumed.
constexpr std::size_t kOneInBurst = 150;
constexpr std::size_t kOneCountedAnew = 32;
// Share of the learning time, in tenths, for which samples are kept after a failed attempt. The
// samples that caused the failure may soon be too old to count.
constexpr std::int64_t kKeptTenths = 9;
// If a burst's last sample is late by at least this many periods, a sample may have been lost.
constexpr double kSurely = 1.1;

// A point in the plane of sample index and arrival time.
struct HullPoint {
    double index = 0;
    double arrival_ns = 0;
};

bool is_above_chord(HullPoint const& a, HullPoint const& b, HullPoint const& c)
{
    return (b.arrival_ns - a.arrival_ns) * (c.index - a.index)
        >= (c.arrival_ns - a.arrival_ns) * (b.index - a.index);
}

} // namespace

Timestamp EvenTimes::add(Timestamp arrival)
{
    auto const last_arrival
        = samples_.empty() ? Timestamp::min() : origin_ + Duration(samples_.back().arrival);
    if (samples_.empty() || arrival < last_arrival || arrival - last_arrival > kSilence)
        begin(arrival);
    std::int64_t const since_ns = (arrival - origin_).count();
    double const period_ns = is_line_known_ ? period_ns_ : rough_period_ns();
    bool is_alone = samples_.empty() || period_ns == 0;
    if (!is_alone) {
        is_alone = static_cast<double>(since_ns - samples_.back().arrival) >= period_ns / 2;
        if (is_alone)
            end_burst();
    }
    samples_.push_back({ .index = next_index_++, .arrival = since_ns, .joins_burst = !is_alone });
    joined_ += !is_alone;

    auto time = arrival;
    if (is_evened_) {
        auto const line = origin_ + Duration(std::llround(line_ns(samples_.back().index)));
        time = std::min(arrival, line);
        time = std::max(time, last_time_ + std::chrono::microseconds(1));
    }
    return last_time_ = time;
}

Duration EvenTimes::burst_interval() const
{
    if (!is_evened_ || bursts_ == 0)
        return {};
    return Duration(samples_.back().arrival - samples_.front().arrival)
        / static_cast<std::int64_t>(bursts_);
}

// Starts anew with the very first sample, or with the first sample after a silence.
void EvenTimes::begin(Timestamp arrival)
{
    samples_.clear();
    bursts_ = joined_ = counted_anew_ = 0;
    origin_ = arrival;
    next_index_ = 0;
    last_time_ = Timestamp::min();
    offset_ns_ = 0;
}

double EvenTimes::line_ns(std::int64_t index) const
{
    return offset_ns_ + period_ns_ * static_cast<double>(index);
}

// Returns the mean spacing of the remembered samples; 0 if there are too few.
double EvenTimes::rough_period_ns() const
{
    if (samples_.size() < kFewestSamples / 2)
        return 0;
    return static_cast<double>(samples_.back().arrival - samples_.front().arrival)
        / static_cast<double>(samples_.size() - 1);
}

double EvenTimes::late_periods(Sample const& sample) const
{
    return (static_cast<double>(sample.arrival) - line_ns(sample.index)) / period_ns_;
}

// Returns how many samples were lost before the last sample of a burst. The number is negative if
// there were more samples than expected.
std::int64_t EvenTimes::missed_at(Sample const& last) const
{
    constexpr double kBarely = 0.1;
    constexpr double kPlainly = 1.5;
    constexpr int kAgree = 3;
    double const late = late_periods(last);
    auto const length_ns = last.arrival - samples_.front().arrival;
    if ((late < -0.5 && length_ns >= kShortestFit_ns)
        || (late < -kBarely && length_ns >= 4 * kShortestFit_ns))
        return std::min<std::int64_t>(-1, std::llround(late));
    if (late < kSurely)
        return 0;
    if (late >= kPlainly)
        return std::max<std::int64_t>(1, std::llround(late - 0.6));
    int agree = 0;
    for (auto sample = samples_.rbegin(); sample != samples_.rend() && agree < kAgree; ++sample) {
        bool const is_late = late_periods(*sample) >= kSurely;
        if (sample->is_last_of_burst && !is_late)
            break;
        agree += sample->is_last_of_burst;
    }
    return agree == kAgree ? 1 : 0;
}

// Marks the newest sample as the last of its burst.
void EvenTimes::end_burst()
{
    auto& last = samples_.back();
    last.is_last_of_burst = true;
    ++bursts_;
    if (is_evened_)
        if (auto const missed = missed_at(last); missed != 0 && unexplained_bursts() > 0) {
            last.index += missed;
            last.is_counted_anew = true;
            next_index_ += missed;
            ++counted_anew_;
        }
    while (last.arrival - samples_.front().arrival > kMemory_ns)
        forget_oldest();
    judge();
}

// Fits the line again and returns how many bursts are still too late for it, unless it gets a step.
// If it returns 0, only the period was slightly wrong. This happens if bursts have nearly the
// rhythm of the samples, because the period then shows only occasionally.
std::size_t EvenTimes::unexplained_bursts()
{
    fit();
    return static_cast<std::size_t>(
        std::count_if(samples_.begin(), samples_.end(), [&](Sample const& sample) {
            return sample.is_last_of_burst && late_periods(sample) > kSurely;
        }));
}

void EvenTimes::forget_oldest()
{
    bursts_ -= samples_.front().is_last_of_burst;
    joined_ -= samples_.front().joins_burst;
    counted_anew_ -= samples_.front().is_counted_anew;
    samples_.pop_front();
}

// Decides whether sample times are to be corrected. If so, fits the line from index to time.
void EvenTimes::judge()
{
    auto const count = samples_.size();
    auto const first = std::find_if(samples_.begin(), samples_.end(),
                                    [](Sample const& one) { return one.is_last_of_burst; });
    bool const is_short = count < kFewestSamples || bursts_ < kFewestBursts
        || samples_.back().arrival - first->arrival < learning_time_ns_;
    bool const steps_often = counted_anew_ > 2 + count / kOneCountedAnew;
    bool const has_bursts = is_short ? is_evened_ : joined_ * kOneInBurst >= count;
    bool const was_evened = std::exchange(is_evened_, has_bursts && !steps_often);
    if (is_evened_ && was_evened)
        fit();
    else if (is_evened_)
        is_evened_ = unexplained_bursts() == 0 && is_line_known_;
    // Counting samples has failed: the device does not sample evenly, or samples were lost.
    if (has_bursts && !is_evened_) {
        is_line_known_ = false;
        if (was_evened)
            learning_time_ns_ = std::min(2 * learning_time_ns_, kLongestLearning_ns);
        auto const kept_ns = was_evened ? 0 : learning_time_ns_ * kKeptTenths / 10;
        while (samples_.size() > 1 && samples_.back().arrival - samples_.front().arrival >= kept_ns)
            forget_oldest();
    }
}

// Fits the line below the last samples of all bursts by the method of Moon, Skelly and Towsley, as
// in ClockMap::fit(): the edge of their lower convex hull that spans their mean index. If the
// samples cover too little time, the period stays unchanged.
void EvenTimes::fit()
{
    std::vector<HullPoint> hull;
    double sum = 0;
    for (auto const& sample : samples_) {
        if (!sample.is_last_of_burst)
            continue;
        HullPoint const point { static_cast<double>(sample.index),
                                static_cast<double>(sample.arrival) };
        if (!hull.empty() && point.index <= hull.back().index)
            continue; // Counting found one sample too many, so the index repeats.
        while (hull.size() >= 2 && is_above_chord(hull[hull.size() - 2], hull.back(), point))
            hull.pop_back();
        hull.push_back(point);
        sum += point.index;
    }
    bool const is_long = hull.back().arrival_ns - hull.front().arrival_ns >= kShortestFit_ns;
    if (is_long) {
        double const mean = sum / static_cast<double>(bursts_);
        std::size_t right = 1;
        while (right + 1 < hull.size() && hull[right].index < mean)
            ++right;
        period_ns_ = (hull[right].arrival_ns - hull[right - 1].arrival_ns)
            / (hull[right].index - hull[right - 1].index);
        is_line_known_ = true;
    }
    offset_ns_ = std::numeric_limits<double>::max();
    for (auto const& point : hull)
        offset_ns_ = std::min(offset_ns_, point.arrival_ns - period_ns_ * point.index);
}

} // namespace tractus::calib
