#pragma once

#include "engine/base/time.h"

#include <cstddef>
#include <deque>
#include <limits>
#include <optional>

namespace tractus::calib {

// Detects a string that slips within 6 to 300 ms, no faster than a hand may move the surface, by
// how abruptly it begins and ends.
//
// A muscle needs some 50 ms to change a speed: hands tremble at 8 to 12 Hz and hardly faster. Over
// a third of a second a surface's height is therefore nearly a polynomial, and a hand's quick push
// has rounded corners. A slip has two sharp ones: a constant speed is added and, soon after, taken
// away again. A blow on the surface, or a stop that it meets, makes one sharp corner, or two in the
// same direction when it bounces.
//
// The test is a ratio of likelihoods, for readings with independent normal errors. Pairs of
// opposite corners are found with a matched filter. Each pair is then explained in several ways,
// all of them together with the same smooth movement:
//
// - nothing else;
// - one sharp corner anywhere;
// - a push, of which at least one change of speed takes a hand's time;
// - a slip.
//
// A slip is reported if it leaves hardly more than the readings' noise and if the logarithm of its
// likelihood exceeds that of each other explanation by half of kMinEvidence. Nothing distinguishes
// a slip slower than kMinSpeed_mm_per_s from a motor that starts abruptly, or one with rounded
// corners from a hand's push; these are not reported, and neither are slips across a gap in the
// readings, or those after which the surface rests where it has met a stop before. The stops of the
// surface's travel reveal them later (lowest_stop.h).
//
// Heights come in time order. No clock is read: equal heights give equal results.
class SlowSlip {
public:
    static constexpr double kMinEvidence = 34;
    static constexpr double kMinSpeed_mm_per_s = 42; // Motorised desks rise at up to 40 mm/s.
    static constexpr double kMinStep_mm = 3;

    struct Slip {
        Timestamp begin {};
        Timestamp end {};
        double step_mm = 0;  // Change of the height in addition to the surface's own movement.
        double evidence = 0; // Twice the difference of log likelihoods to the next explanation.
    };

    explicit SlowSlip(double min_evidence = kMinEvidence)
        : min_evidence_(min_evidence)
    {
    }

    // Adds a height; one count of the converter is worth `count_mm`. Returns a slip, once, about
    // 0.1 s after its end.
    std::optional<Slip> push(Timestamp time, double height_mm, double count_mm);

    // Begins anew with the next height, which does not continue the last ones.
    void clear();

private:
    struct Height {
        double seconds = 0; // Time since origin_.
        double mm = 0;
    };

    // A change of speed, as measured by the matched filter.
    struct Corner {
        double seconds = 0;
        double mm_per_s = 0;
    };

    std::optional<Corner> corner_at(double seconds) const;
    bool is_peak(std::size_t corner) const;
    double noise_mm() const;
    bool meets_stop(double seconds) const;
    void forget_oldest();
    std::optional<Slip> best_slip(Corner const& end) const;
    std::optional<Slip> judge(double begin_s, double end_s) const;
    Timestamp time_at(double seconds) const;

    double min_evidence_;
    Timestamp origin_ {}; // Time of the first height since the last clear().
    std::deque<Height> heights_ {};
    std::deque<Corner> corners_ {};
    // Least and greatest height before those in heights_.
    double lowest_mm_ = std::numeric_limits<double>::infinity();
    double highest_mm_ = -std::numeric_limits<double>::infinity();
    double count_mm_ = 0;
    double noise_mm_ = 0; // Last value of noise_mm().
    double next_noise_s_ = 0;
    double next_corner_s_ = 0;
    double told_until_s_ = 0; // Corners before this time belong to slips that were reported.
};

} // namespace tractus::calib
