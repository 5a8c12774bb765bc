#pragma once

#include "engine/base/time.h"
#include "engine/stroke/tip_sample.h"

#include <cstddef>
#include <deque>
#include <optional>

namespace tractus {

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

    bool empty() const { return readings_.empty(); }

    // When the newest reading was. At least one reading must have come.
    Timestamp newest() const;

    struct Estimate {
        double height_mm = 0;
        TipSample::HeightSource kind = TipSample::HeightSource::Interpolated;
    };

    // The height at `time`: interpolated where readings lie at most `max_age` before and after it,
    // extrapolated from the side where one does, otherwise no value.
    std::optional<Estimate> at(Timestamp time, Duration max_age) const;

private:
    struct Reading {
        Timestamp time {};
        double height_mm = 0;
    };

    // The line through the readings within kHalfWidth of `centre`, at `time`. No value where they
    // are too few or too close together to give one.
    std::optional<double> fit(Timestamp centre, Timestamp time) const;

    std::deque<Reading>::const_iterator first_not_before(Timestamp time) const;

    Duration memory_;
    std::deque<Reading> readings_; // In time order.
};

} // namespace tractus
