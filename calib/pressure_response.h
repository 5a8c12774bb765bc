#pragma once

namespace tractus::calib {

// Pressure from which on a pen draws, and how its ink grows with the pressure. Pens differ, and so
// do hands. Pressures are 0 to 1, of the most that the device can report.
struct PressureResponse {
    // The pen draws while the pressure is above this, once it does until it falls to half of it; so
    // a light hand makes one stroke, and not crumbs. 0: wherever the device says that it touches.
    double threshold = 0; // Below `full`.
    double full = 1;      // The pressure that counts as 1.
    // Exponent between the two: 1 follows the hand, above 1 the ink stays thin for longer, below 1
    // shorter.
    double exponent = 1; // Above 0.
};

// 0 at the threshold and below, 1 at the full pressure and above. Since it is 0 where a stroke
// begins and ends, no stroke has a blob at its end.
double respond(PressureResponse const& response, double pressure);

} // namespace tractus::calib
