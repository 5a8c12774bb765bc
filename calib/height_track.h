#pragma once

#include "engine/base/time.h"
#include "engine/stroke/tip_sample.h"

#include <cstddef>
#include <deque>
#include <optional>

namespace tractus::calib {

// The carriage's last heights, and its height at any instant among them.
//
// A reading is noisy and rounded: one count of a 12 bit converter on a half metre of string is
// 0.12 mm, which would show as steps in a slow stroke. So the height at an instant is the value of
// a straight line through the readings around it, fitted by weighted least squares (local linear
// regression: W. S. Cleveland, "Robust locally weighted regression and smoothing scatterplots",
// JASA 74, 1979; here with Epanechnikov's weights and no robustness). A line follows a steady rise
// without lag. The price is a height too low at the top of a bump and too high in a hollow by
// a w^2 / 10 for an acceleration a and a half width w: 0.06 mm when a hand sways the carriage by
// +-100 mm once in a second and a half.
//
// A single reading that lies outside both its neighbours, farther than a hand could have moved the
// carriage and back, is a spike: the nearer neighbour stands for it (a median of three).
//
// Where readings are missing for longer than the half width, a line through one side would point
// anywhere on the other: there the height follows the cubic curve that joins the lines of both
// sides, with their slopes.
class HeightTrack {
public:
    // Half the width of the fit.
    static constexpr Duration kHalfWidth = std::chrono::milliseconds(18);

    // How much of the past is kept.
    explicit HeightTrack(Duration memory)
        : memory_(memory)
    {
    }

    // A height and when the carriage was there. One that comes late is put in its place; one that
    // is older than the memory, or repeats the reading before it, is dropped.
    void add(Timestamp time, double height_mm);

    // The sensor gave a reading for then that is not to be believed, or no height. Where such
    // readings are all that separates two others, no farther apart than kMostBridged, the height
    // between these is told as if no reading were missing.
    void add_unknown(Timestamp time);
    static constexpr Duration kMostBridged = std::chrono::milliseconds(600);

    // What was unknown since the newest reading separates what comes from what was: it lasts too
    // long.
    void end_bridge();

    bool empty() const { return readings_.empty(); }

    // When the newest reading was. At least one reading must have come.
    Timestamp newest() const;

    struct Estimate {
        double height_mm = 0;
        TipSample::HeightSource kind = TipSample::HeightSource::Interpolated;
    };

    // The longest time for which a movement is carried on where no reading follows.
    static constexpr Duration kCarriedOn = std::chrono::milliseconds(5);

    // The height at `time`: interpolated where readings lie at most `max_age` before and after it.
    // Where there are some on one side only, it is extrapolated from there for kCarriedOn, and held
    // beyond, for nobody knows where the carriage went. Otherwise no value.
    std::optional<Estimate> at(Timestamp time, Duration max_age) const;

    // As at(), but where the carriage starts or stops at once the fit is narrowed to
    // kNarrowHalfWidth: a line through both sides of such a corner cuts it by 3/16 of the change of
    // speed times the half width. So does O. V. Lepski's choice of a bandwidth (Theory Prob. Appl.
    // 35, 1990): the wide fit counts where the narrow one does not contradict it by more than noise
    // can.
    static constexpr Duration kNarrowHalfWidth = std::chrono::milliseconds(6);
    std::optional<Estimate> at_corner(Timestamp time, Duration max_age) const;

    // The height as soon as it can be told: as at(), but past the newest reading the movement is
    // carried on for as long as readings are usually apart, and kCarriedOn at least, so that scarce
    // readings do not lag; for `deliveries` where they come together, so long after each other: a
    // pen's samples may come before the readings that belong to them. What overshoots a stop is
    // bounded: the height is not carried on faster than the last readings moved, nor farther beyond
    // the newest one than it would go at that speed.
    std::optional<Estimate> newest_at(Timestamp time, Duration max_age,
                                      Duration deliveries = {}) const;

private:
    struct Reading {
        Timestamp time {};
        double height_mm = 0;
    };

    using Place = std::deque<Reading>::const_iterator;

    struct LineAt {
        double height_mm = 0;
        double mm_per_s = 0;
    };

    // The line through the readings within `half_width` of `centre`, at `time`. No value where they
    // are too few or too close together to give one.
    std::optional<LineAt> fit(Timestamp centre, Timestamp time,
                              Duration half_width = kHalfWidth) const;

    Place first_not_before(Timestamp time) const;
    bool is_bridged(Timestamp from, Timestamp to, Duration max_age) const;
    double without_spike_mm(Place const& reading) const;
    double between_mm(Place const& after, Timestamp time) const;
    static constexpr int kWidestInGap = 5; // Times kHalfWidth.
    std::optional<LineAt> slope_at(Timestamp side, Timestamp gap_begin, Timestamp gap_end) const;
    double across_mm(Place const& before, Timestamp time) const;
    Duration usual_spacing() const;
    Place some_time_before(Place const& reading) const;
    static double speed_mm_per_s(Place const& from, Place const& to);
    double newest_speed_mm_per_s() const;

    Duration memory_;
    std::deque<Reading> readings_;  // Readings in time order.
    std::deque<Timestamp> unknown_; // Likewise.
};

} // namespace tractus::calib
