#pragma once

#include "engine/base/time.h"

#include <cstddef>
#include <deque>
#include <vector>

namespace tractus::calib {

// Tells readings that a surface can have from those that it cannot: a contact that bounces, a
// reading torn on the wire, a string that slips.
//
// A surface has mass: from one reading to the next it goes on as it did, within what a hand's
// acceleration can change. A reading that is farther off is doubted, until one of these holds:
// - the surface goes on where it was expected: what was doubted in between was wrong;
// - kFewInRun doubted readings in a row lie on a smooth curve that leads back to where the surface
//   was last: it started, stopped or turned at once, or moved on unseen;
// - more than kMostWrong in a row lie on a smooth curve, for at least kLeastStep: the surface is
//   there now, however it got there (after a pause of the computer, or since the string has
//   slipped).
// So up to kMostWrong wrong readings in a row are never believed. What is too small to be told from
// a movement is: less than 1 mm at 500 readings a second, 5 mm at 50.
//
// Readings of one sensor come in the order of their arrival. It reads no clock: the same readings
// give the same judgements.
class HeightJudge {
public:
    static constexpr std::size_t kMostWrong = 10;
    static constexpr std::size_t kFewInRun = 4;
    static constexpr Duration kLeastStep = std::chrono::milliseconds(40);

    // Limits of hands: no surface moves faster, or goes on changing its speed faster, while one
    // draws on it.
    static constexpr double kFastest_mm_per_s = 2000;
    static constexpr double kQuickest_mm_per_ss = 4000;

    struct Reading {
        Timestamp arrival {}; // Or, where times are evened, when it was taken by EvenTimes.
        Timestamp instant {}; // When the surface was there; the judge only hands it on.
        double height_mm = 0;
    };

    enum class Verdict {
        Believed,
        Doubted,
        Step, // Believed, with those that agree with it, though no surface gets there so fast.
    };

    // Judges the next reading of a converter of which one count is `count_mm` there. Appends to
    // `believed` what is believed from now on, in order: the reading, and what was doubted before.
    Verdict judge(Reading const& reading, double count_mm, std::vector<Reading>& believed);

    // A reading came that tells no height: one at an end of the converter's range. Where the
    // surface goes meanwhile is as unknown as in a pause.
    void miss();

    // How many readings have come since the last believed one.
    std::size_t doubted_in_a_row() const { return doubted_in_a_row_; }

private:
    using Readings = std::deque<Reading>;
    static constexpr double kUnknownBend_mm = 0.5; // Until enough readings have come.

    // The line through the last readings of a track, at the last one.
    struct Line {
        double height_mm = 0;
        double mm_per_s = 0;
        double span_s = 0;     // From the first of these readings to the last.
        bool is_known = false; // Enough readings tell the speed.
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
    void believe_run(std::vector<Reading>& believed);

    Readings track_; // The last believed ones.
    Readings run_;   // The last doubted ones that agree with each other.
    std::size_t doubted_in_a_row_ = 0;

    // Of all readings, believed or not.
    Timestamp last_arrival_ = Timestamp::min();
    std::deque<double> intervals_s_;
    std::deque<double> heights_mm_;          // The last two.
    std::deque<double> bends_mm_;            // Second differences.
    double usual_interval_s_ = 0;            // The mean …
    double longest_interval_s_ = 0;          // … and, but for one, the longest of the last ones.
    double interval_s_ = 0;                  // Before the newest reading.
    double usual_bend_mm_ = kUnknownBend_mm; // Median of the second differences of right readings.
    double count_mm_ = 0;
};

} // namespace tractus::calib
