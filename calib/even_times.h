#pragma once

#include "engine/base/time.h"

#include <cstddef>
#include <cstdint>
#include <deque>

namespace tractus::calib {

// Tells when a device that samples evenly, but has no clock that it tells of, took its samples,
// from the times at which they arrived.
//
// A sample is never early: what brings it, USB, a radio, the scheduler, adds a delay that is never
// negative, and often keeps samples back to bring several at once. The samples themselves are
// evenly spaced. So the n-th one was taken on the line under all arrivals over n, as a ClockMap has
// it for devices with a clock, and what lies above the line is the delivery's jitter. The least
// delay stays in the result, as a constant latency.
//
// Times are moved only where arrivals prove that they have to be: where at least one in 150
// samples of the last eight seconds arrived sooner after the one before it than half a period,
// which no evenly sampling device can mean; and where counting explains them, which is when each
// burst's last sample is less than a period late, for a burst brings all that has been taken until
// then. A sample that was lost or is one too many shows as a step of a period, at the latest three
// bursts later, and is counted in; where there are many such steps the device does not sample
// evenly: then all arrivals stay as they are, as in the first half second, and twice as much has
// to be seen before it is tried again, up to four seconds. The beginning is a half second of which
// nothing was lost, so that a loss cannot pass for another period. A stream whose bursts bring one
// sample each stays as it is, too.
//
// After a silence of kSilence the device may have begun anew: its period is remembered, when its
// samples fall is not, and is found again within the first bursts.
//
// A bound that no device without a clock can escape: where bursts keep step with the samples, the
// last of each waits equally long for its delivery, up to a period, and that counts as latency.
//
// A pure function of the arrivals: the same ones give the same times.
class EvenTimes {
public:
    static constexpr Duration kSilence = std::chrono::milliseconds(100);

    // The next sample's arrival; returns when it was taken, by what is known now: at most the
    // arrival, and, where times are moved, later than the last time returned.
    Timestamp add(Timestamp arrival);

    // Whether the last time was told by the line, not by its arrival.
    bool is_evened() const { return is_evened_; }

    // How long it usually takes from one burst to the next; zero where times are not moved.
    Duration burst_interval() const;

private:
    struct Sample {
        std::int64_t index = 0;   // Samples that were lost are counted.
        std::int64_t arrival = 0; // Nanoseconds since origin_.
        bool joins_burst = false; // Came too soon after the one before it.
        bool is_last_of_burst = false;
        bool is_counted_anew = false; // A step of periods was found here.
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
    std::deque<Sample> samples_;   // Of the last eight seconds, and since the last silence.
    std::size_t bursts_ = 0;       // Of them, the last ones of bursts …
    std::size_t joined_ = 0;       // … those that came too soon …
    std::size_t counted_anew_ = 0; // … and those where a step was found.
    Timestamp last_time_ {};       // The one returned last.
    bool is_evened_ = false;

    static constexpr std::int64_t kShortestFit_ns = 500'000'000;
    std::int64_t to_learn_ns_ = kShortestFit_ns; // Doubles whenever counting has failed.
    bool is_line_known_ = false; // Period and all, of this or of the time before a silence.
    double period_ns_ = 0;
    double offset_ns_ = 0; // Height of the line at index 0.
};

} // namespace tractus::calib
