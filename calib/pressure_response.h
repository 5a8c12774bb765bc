#pragma once

namespace tractus::calib {

// Pressure at which a pen begins to draw, and how its ink grows with the pressure. Pens and hands
// differ. Pressures are 0 to 1, relative to the device's maximum.
struct PressureResponse {
    // The pen begins to draw above this pressure and continues until it falls to half of it, so
    // that a light hand makes one stroke and not fragments. 0: the pen draws whenever the device
    // reports a touch.
    double threshold = 0; // Less than `full`.
    double full = 1;      // Pressure from which the pen draws at full strength.
    // Exponent of the curve from the threshold to full pressure: 1 is proportional; above 1 the ink
    // stays thin for longer, below 1 for less long.
    double exponent = 1; // Greater than 0.
};

// Returns 0 at the threshold and below, 1 at full pressure and above. Since it is 0 where a stroke
// begins and ends, strokes have no blobs at their ends.
double respond(PressureResponse const& response, double pressure);

} // namespace tractus::calib
