#pragma once

#include "drivers/reports/pen_sample.h"
#include "engine/base/vectors.h"
#include "tests/physics/potentiometer.h"

#include <functional>
#include <vector>

namespace tractus::physics {

// A leaning pen on a tablet that locates it by its coil, modelled from first principles: a rod
// rotated about two axes, seen from above.

// How a person holds the pen at one moment: the angle from upright, and the direction,
// counterclockwise from +x seen from above.
struct Hold {
    double lean_rad = 0;
    double azimuth_rad = 0;
};
using Holding = std::function<Hold(double seconds)>;
// Returns the nib's position on the tablet, in millimetres.
using NibPath = std::function<Vec2(double seconds)>;

enum class Sight {
    Below, // The tablet locates the point directly below the coil.
    // The tablet locates the point where the coil's axis meets the nib's height, displaced by the
    // tangent of the lean, as a tilted magnetic field could cause it.
    Along,
};

struct Tablet {
    double coil_mm = 10; // Distance of the coil from the nib along the pen.
    Sight sight = Sight::Below;
    double place_noise_mm = 0.02;
    double tilt_noise_deg = 0.5; // Noise before tilts are rounded to whole degrees.
    double tilt_late_s = 0;      // Delay of tilts relative to positions.
    bool is_y_inverted = false;  // True: the tilt towards the user has the opposite sign.
    double pen_hz = 133;
};

// The tablet's samples while the nib moves, and the nib's true positions.
struct PenRecording {
    std::vector<drivers::PenSample> samples {};
    std::vector<Vec2> nibs_mm {};
};
PenRecording record_pen(NibPath const& way, Holding const& holding, double seconds,
                        Tablet const& tablet, Dice& dice);

} // namespace tractus::physics
