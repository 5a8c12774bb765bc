#pragma once

#include "calib/rig.h"
#include "drivers/reports/height_sample.h"
#include "drivers/reports/pen_sample.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstddef>
#include <span>

namespace tractus::calib {

// Delay of the pen relative to the height, found with a pen that follows a fixed inclined edge
// while the surface moves up and down: since the edge is fixed, position and height must agree.
struct LatencyFit {
    // Tablet's latency minus height sensor's; only their difference is observable. Negative if the
    // height lags.
    double delay_ms = 0;
    double error_ms = 0; // Standard error of delay_ms.

    // Distance along the tablet between the pen's positions on the way up and on the way down,
    // after correcting the delay, and its standard error. It means that the pen is dragged, or that
    // the string follows the surface with slack.
    double direction_mm = 0;
    double direction_error_mm = 0;

    // Correlation of position and height at `delay_ms`: 1 for a perfect edge and hand.
    double correlation = 0;
    double rms_mm = 0; // Root mean square distance of the pen from the edge.
    double run_mm = 0; // Distance that the pen covered along the tablet.
    std::size_t touches = 0;
};

// Finds the delay within 150 ms on either side of zero: first the greatest correlation of position
// and height among delays 2 ms apart, then by least squares for the edge and the delay together
// (Gauss-Newton), which is as accurate as the noise allows and gives a standard error. A dragged
// pen and a slack string also lag, but by a length, not by a time: a term c tanh(v / 30 mm/s) for
// each axis of the tablet, where v is the speed of the height, separates this from the delay, since
// hands vary their speed. The rig's own latencies are ignored, and times are always evened
// (EvenTimes).
//
// Fails with a user error that says what to do: fewer than 200 touches with a height, less than 50
// mm of rise or 20 mm along the tablet, fewer than two turns between up and down, position and
// height that do not correlate (below 0.9), a delay at the limit of the search.
Result<LatencyFit> fit_latency(std::span<drivers::PenSample const> pens,
                               std::span<drivers::HeightSample const> heights, Rig const& rig);

// Returns the rig with evened times and with latencies that differ by the fitted delay. The height
// sensor's latency stays and the tablet's is changed. If the tablet's would be negative, it becomes
// zero and the height sensor's is changed instead.
Rig with_delay(Rig rig, LatencyFit const& fit);

} // namespace tractus::calib
