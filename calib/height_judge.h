#pragma once

#include "engine/base/time.h"

#include <cstddef>
#include <deque>
#include <vector>

namespace tractus::calib {

// Separates plausible readings from those that a surface cannot have, caused by a bouncing contact,
// a reading corrupted on the wire, or a slipping string.
//
// A surface has mass: between readings its movement changes only as much as a hand can accelerate
// it. A reading outside these limits is doubted until one of these is true:
// - the surface continues where it was expected: the doubted readings were wrong;
// - kFewInRun doubted readings in a row lie on a smooth curve that leads back to the last position:
//   the surface started, stopped or turned abruptly, or moved unobserved;
// - more than kMaxWrong readings in a row lie on a smooth curve, for at least kMinStep: the
//   surface is there now, however it got there (after the computer paused, or because the string
//   slipped).
// Up to kMaxWrong wrong readings in a row are therefore never believed. Errors too small to differ
// from movement are believed: less than 1 mm at 500 readings a second, 5 mm at 50.
//
// Readings of one sensor come in the order of their arrival. No clock is read: equal readings give
// equal judgements.
class HeightJudge {
public:
    static constexpr std::size_t kMaxWrong = 10;
    static constexpr std::size_t kFewInRun = 4;
    static constexpr Duration kMinStep = std::chrono::milliseconds(40);

    // Limits of hands: the greatest speed of a surface, and the greatest sustained acceleration,
    // while drawing on it.
    static constexpr double kFastest_mm_per_s = 2000;
    static constexpr double kMaxAcceleration_mm_per_ss = 4000;

    struct Reading {
        Timestamp arrival {}; // Arrival or, with evened times, the time of sampling by EvenTimes.
        Timestamp instant {}; // Time at which the surface was there; not used by the judge itself.
        double height_mm = 0;
    };

    enum class Verdict {
        Believed,
        Doubted,
        // The reading is believed, together with the readings that agree with it, although no
        // surface moves so fast.
        Step,
    };

    // Judges the next reading, at which one count of the converter is worth `count_mm`. Appends to
    // `believed`, in order, everything that is believed from now on: the reading, and readings
    // doubted before.
    Verdict judge(Reading const& reading, double count_mm, std::vector<Reading>& believed);

    // Notes a reading without a height, at an end of the converter's range. The movement meanwhile
    // is as unknown as in a pause.
    void miss();

    // Number of readings that have been doubted since the last believed one.
    std::size_t doubted_in_a_row() const { return doubted_in_a_row_; }

private:
    using Readings = std::deque<Reading>;
    // Second difference of heights, assumed until enough readings have come to measure it.
    static constexpr double kInitialBend_mm = 0.5;

    // A line through the last readings of a track, evaluated at the last one.
    struct Line {
        double height_mm = 0;
        double mm_per_s = 0;
        double span_s = 0;     // Time from the first of the line's readings to the last.
        bool is_known = false; // True if there are enough readings to determine the speed.
    };

    void learn(Reading const& reading);
    Line line_through(Readings const& track) const;
    bool is_new() const;
    double unseen_s() const;
    double noise_mm() const;
    double jitter_mm(double mm_per_s) const;
    bool goes_on(Reading const& reading) const;
    bool continues_run(Reading const& reading) const;
    bool run_leads_back() const;
    void believe(Reading const& reading);
    void accept_run(std::vector<Reading>& believed);

    Readings track_; // The last believed readings.
    Readings run_;   // The last doubted readings that agree with each other.
    std::size_t doubted_in_a_row_ = 0;

    // Statistics of all readings, believed or not.
    Timestamp last_arrival_ = Timestamp::min();
    std::deque<double> intervals_s_;
    std::deque<double> heights_mm_; // The last two heights.
    std::deque<double> bends_mm_;   // Second differences of the heights.
    double usual_interval_s_ = 0;   // Mean of the last intervals between readings.
    double longest_interval_s_ = 0; // Second longest of the last intervals between readings.
    double interval_s_ = 0;         // Interval before the newest reading.
    // Median of the second differences of correct readings.
    double usual_bend_mm_ = kInitialBend_mm;
    double count_mm_ = 0;
};

} // namespace tractus::calib
