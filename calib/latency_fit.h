#pragma once

#include "calib/rig.h"
#include "drivers/reports/height_sample.h"
#include "drivers/reports/pen_sample.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstddef>
#include <span>

namespace tractus::calib {

// How much later than the height the pen arrives, from a pen that follows a fixed inclined edge
// while the surface moves up and down: where the edge is fixed, place and height must agree.
struct LatencyFit {
    // Tablet's latency less height sensor's; only their difference shows. Below 0 where the height
    // is the later one.
    double delay_ms = 0;
    double error_ms = 0; // Standard error.

    // How far apart along the tablet the pen is on its way up and on its way down, the delay taken
    // off: it is dragged, or the string follows the surface with some slack. With standard error.
    double direction_mm = 0;
    double direction_error_mm = 0;

    // Correlation of place and height at that delay: 1 for a perfect edge and hand.
    double correlation = 0;
    double rms_mm = 0; // Root mean square by which the pen strayed from the edge.
    double run_mm = 0; // How far it went along the tablet.
    std::size_t touches = 0;
};

// Finds the delay within 150 ms to either side of none: first as the greatest correlation of place
// and height among delays 2 ms apart, then by least squares for the edge and the delay together
// (Gauss and Newton), which is as exact as the noise allows and tells its error. A pen that is
// dragged and a string with slack are always behind, as a delay is, but by a length and not by a
// time: a term c tanh(v / 30 mm/s) for each axis of the tablet, v the height's speed, keeps that
// apart, since a hand is not always equally quick. The rig's own latencies do not matter, and
// the times are evened out (EvenTimes) whatever it says.
//
// Fails, as the user's fault, with what to do: fewer than 200 touches with a height, less than 50
// mm of rise or 20 mm along the tablet, fewer than two turns from up to down or down to up, place
// and height that do not belong together (correlation below 0.9), a delay at the end of the search.
Result<LatencyFit> fit_latency(std::span<drivers::PenSample const> pens,
                               std::span<drivers::HeightSample const> heights, Rig const& rig);

// The rig with times that are evened out and latencies that differ by the delay: the height
// sensor's stays, and the tablet's follows, unless that would be less than nothing; then it is
// nothing, and the height sensor's follows.
Rig with_delay(Rig rig, LatencyFit const& fit);

} // namespace tractus::calib
