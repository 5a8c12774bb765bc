#pragma once

#include "engine/base/time.h"

#include <cstddef>
#include <cstdint>
#include <deque>

namespace tractus::calib {

// Estimates when a device took its samples from the times at which they arrived, for devices that
// sample evenly but do not report their clock.
//
// Delivery (USB, radio, scheduler) adds a delay that is never negative, and often collects several
// samples into a burst. The samples themselves are evenly spaced. If arrival times are plotted over
// the sample number, the true sampling times therefore form a line below all arrivals, as in a
// ClockMap for devices with a clock. An arrival's distance above the line is delivery jitter. The
// minimum delay remains in the result as a constant latency.
//
// Times are corrected only if the arrivals prove the need: at least one in 150 samples of the last
// eight seconds arrived less than half a period after its predecessor, which an evenly sampling
// device cannot cause. Counting must also explain the arrivals: the last sample of each burst must
// be less than a period late, because a burst delivers everything taken until then. A lost or
// surplus sample appears as a step of one period, at the latest three bursts later, and is counted.
// If there are many such steps, the device does not sample evenly. All arrival times are then kept,
// as in the first half second, and the next attempt needs twice as much data, up to four seconds.
// The first half second must be without loss, so that a loss is not mistaken for another period. A
// stream is not corrected either if each of its bursts has only one sample.
//
// After a silence of kSilence the device may have restarted: its period is kept, but the phase of
// its samples is determined again from the first bursts.
//
// One error cannot be avoided without a device clock: if bursts keep step with the samples, the
// last sample of each burst waits equally long for delivery, up to a period. This counts as
// latency.
//
// The result depends only on the arrivals: equal arrivals give equal times.
class EvenTimes {
public:
    static constexpr Duration kSilence = std::chrono::milliseconds(100);

    // Adds a sample's arrival. Returns the estimate of when it was taken: at most the arrival and,
    // while times are corrected, later than the previous result.
    Timestamp add(Timestamp arrival);

    // True if the last time was estimated from the fitted line and is not just the arrival.
    bool is_evened() const { return is_evened_; }

    // Mean time from one burst to the next; zero while times are not corrected.
    Duration burst_interval() const;

private:
    struct Sample {
        std::int64_t index = 0;   // Index of the sample; lost samples are counted too.
        std::int64_t arrival = 0; // Arrival in nanoseconds since origin_.
        // True if the sample came too soon after its predecessor to be a separate delivery.
        bool joins_burst = false;
        bool is_last_of_burst = false;
        // True if the line through the arrivals steps by whole periods at this sample.
        bool is_counted_anew = false;
    };

    void begin(Timestamp arrival);
    void end_burst();
    std::size_t unexplained_bursts();
    std::int64_t missed_at(Sample const& last) const;
    double late_periods(Sample const& sample) const;
    void forget_oldest();
    void judge();
    void fit();
    double line_ns(std::int64_t index) const;
    double rough_period_ns() const;

    Timestamp origin_ {};
    std::int64_t next_index_ = 0;
    // Samples of the last eight seconds, none older than the last silence.
    std::deque<Sample> samples_;
    std::size_t bursts_ = 0;       // Number of samples_ that are the last of a burst.
    std::size_t joined_ = 0;       // Number of samples_ that join a burst.
    std::size_t counted_anew_ = 0; // Number of samples_ at which a step was found.
    Timestamp last_time_ {};       // Time returned by the last add().
    bool is_evened_ = false;

    // Least time over which a period is fitted.
    static constexpr std::int64_t kShortestFit_ns = 500'000'000;
    // Least time in nanoseconds before correction is attempted; doubles whenever counting has
    // failed.
    std::int64_t learning_time_ns_ = kShortestFit_ns;
    // True if the period is known, from samples_ or from before a silence.
    bool is_line_known_ = false;
    double period_ns_ = 0;
    // Arrival that the line predicts for sample 0, in nanoseconds since origin_.
    double offset_ns_ = 0;
};

} // namespace tractus::calib
