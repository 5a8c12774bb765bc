#include "drivers/pens/report_rhythm.h"

#include <algorithm>

namespace tractus::drivers {

namespace {

constexpr std::size_t kRemembered = 64; // Number of intervals in the running mean.
// Number of consecutive repetitions of a report that proves streaming.
constexpr std::size_t kProof = 3;
// Intervals up to this multiple of the mean belong to the tablet's pace.
constexpr int kOwnPace = 4;
// Longer pauses do not count towards the pace, since even the slowest tablets send 30 reports a
// second.
constexpr Duration kLongestInterval = std::chrono::milliseconds(60);

} // namespace

void ReportRhythm::push(Timestamp received, PenFields const& fields)
{
    if (last_) {
        auto const interval = received - last_->received;
        bool const is_own_pace
            = interval <= kLongestInterval && (counted_ == 0 || interval <= kOwnPace * mean_);
        equal_ = is_own_pace && fields == last_->fields ? equal_ + 1 : 0;
        is_proved_ |= equal_ >= kProof;
        if (interval >= Duration::zero() && interval <= kLongestInterval)
            count(interval);
    } else {
        equal_ = 0;
    }
    last_ = { received, fields };
}

void ReportRhythm::count(Duration interval)
{
    counted_ = std::min(counted_ + 1, kRemembered);
    mean_ += (interval - mean_) / static_cast<Duration::rep>(counted_);
}

std::optional<Duration> ReportRhythm::streaming_interval() const
{
    return is_proved_ && !is_disproved_ ? std::optional(mean_) : std::nullopt;
}

} // namespace tractus::drivers
