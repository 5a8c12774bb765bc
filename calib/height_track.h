#pragma once

#include "engine/base/time.h"
#include "engine/stroke/tip_sample.h"

#include <cstddef>
#include <deque>
#include <optional>

namespace tractus::calib {

// The carriage's recent heights, and its height at any instant among them.
//
// A reading is noisy and quantised: one count of a 12-bit converter on half a metre of string is
// 0.12 mm, which would be visible as steps in a slow stroke. The height at an instant is therefore
// the value of a line through the readings around it, fitted by weighted least squares (local
// linear regression: W. S. Cleveland, "Robust locally weighted regression and smoothing
// scatterplots", JASA 74, 1979; here with Epanechnikov's weights and without robustness). A line
// follows a steady rise without lag. Its cost is a height too low at the top of a bump and too high
// in a hollow, by a w^2 / 10 for an acceleration a and a half width w: 0.06 mm when a hand sways
// the carriage by +-100 mm once in a second and a half.
//
// A single reading that lies outside both its neighbours, farther than a hand could have moved the
// carriage and back, is a spike: the nearer neighbour replaces it (a median of three).
//
// If readings are missing for longer than the half width, a line through one side would be
// meaningless on the other. There the height follows the cubic curve that joins the lines of both
// sides with their slopes.
class HeightTrack {
public:
    // Half the width of the time window of a fit.
    static constexpr Duration kHalfWidth = std::chrono::milliseconds(18);

    // `memory` is the time for which past readings are kept.
    explicit HeightTrack(Duration memory)
        : memory_(memory)
    {
    }

    // Adds a height at an instant. A late one is inserted in its place; one that is older than the
    // memory, or repeats the previous reading, is dropped.
    void add(Timestamp time, double height_mm);

    // Adds an instant with a reading that is not believable or has no height. Two known readings
    // with only such readings between them may be up to kMaxBridged apart: the height between them
    // is then interpolated as if no reading were missing.
    void add_unknown(Timestamp time);
    static constexpr Duration kMaxBridged = std::chrono::milliseconds(600);

    // Ends the bridging of unknown readings since the newest height, because there are too many.
    void end_bridge();

    bool empty() const { return readings_.empty(); }

    // Time of the newest reading. At least one reading must have been added.
    Timestamp newest() const;

    struct Estimate {
        double height_mm = 0;
        TipSample::HeightSource kind = TipSample::HeightSource::Interpolated;
    };

    // Longest extrapolation of a movement without further readings.
    static constexpr Duration kExtrapolation = std::chrono::milliseconds(5);

    // Returns the height at `time`: interpolated if there are readings at most `max_age` before and
    // after it. With readings on one side only, it is extrapolated for kExtrapolation and then
    // held, since the movement is not known. Otherwise no value.
    std::optional<Estimate> at(Timestamp time, Duration max_age) const;

    // Like at(), but narrows the fit to kNarrowHalfWidth where the carriage starts or stops
    // abruptly: a line across such a corner cuts it by 3/16 of the change of speed times the half
    // width. The bandwidth is chosen as by O. V. Lepski (Theory Prob. Appl. 35, 1990): the wide fit
    // is used if the narrow one does not contradict it by more than noise.
    static constexpr Duration kNarrowHalfWidth = std::chrono::milliseconds(6);
    std::optional<Estimate> at_corner(Timestamp time, Duration max_age) const;

    // Returns the height with the least delay: like at(), but beyond the newest reading the
    // movement is extrapolated for the usual spacing of readings, at least kExtrapolation, so that
    // sparse readings do not cause a lag. If readings arrive in bundles, it is extrapolated for the
    // time between `deliveries`, since a pen's samples may arrive before the readings that belong
    // to them. Overshoot at a stop is bounded: the height is extrapolated neither faster than the
    // last readings moved, nor farther than that speed reaches.
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

    // Fits a line to the readings within `half_width` of `centre` and evaluates it at `time`. No
    // value if the readings are too few or too close together.
    std::optional<LineAt> fit(Timestamp centre, Timestamp time,
                              Duration half_width = kHalfWidth) const;

    Place first_not_before(Timestamp time) const;
    bool is_bridged(Timestamp from, Timestamp to, Duration max_age) const;
    double without_spike_mm(Place const& reading) const;
    double between_mm(Place const& after, Timestamp time) const;
    // Greatest half width of a fit beside a gap, as a multiple of kHalfWidth.
    static constexpr int kWidestInGap = 5;
    std::optional<LineAt> slope_at(Timestamp side, Timestamp gap_begin, Timestamp gap_end) const;
    double across_mm(Place const& before, Timestamp time) const;
    Duration usual_spacing() const;
    Place earlier_reading_for_speed(Place const& reading) const;
    static double speed_mm_per_s(Place const& from, Place const& to);
    double newest_speed_mm_per_s() const;

    Duration memory_;
    std::deque<Reading> readings_;  // Readings in time order.
    std::deque<Timestamp> unknown_; // Times of unknown readings, in time order.
};

} // namespace tractus::calib
