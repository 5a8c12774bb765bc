#pragma once

#include "drivers/reports/pen_sample.h"
#include "engine/base/vectors.h"
#include "tests/physics/potentiometer.h"

#include <functional>
#include <vector>

namespace tractus::physics {

// A pen that leans on a tablet which finds it by its coil, written from what a coil and a shaft
// are: a rod turned about two axes, and what of it is seen from above.

// How a person holds the pen at one moment: how far from upright, and towards where,
// counterclockwise from +x seen from above.
struct Hold {
    double lean_rad = 0;
    double azimuth_rad = 0;
};
using Holding = std::function<Hold(double seconds)>;
using NibWay = std::function<Vec2(double seconds)>; // The nib's place on the tablet, mm.

enum class Sight {
    Below, // The tablet finds the point right below the coil.
    Along, // It finds where the coil's axis, carried on upwards, would be over the nib's height:
           // the tangent of the lean, as a magnet's field that leans with its coil might shift it.
};

struct Tablet {
    double coil_mm = 10; // Up the pen from its nib.
    Sight sight = Sight::Below;
    double place_noise_mm = 0.02;
    double tilt_noise_deg = 0.5;    // Before tilts are rounded to whole degrees.
    double tilt_late_s = 0;         // Tilts are so much older than places.
    bool is_y_turned_round = false; // It counts the tilt towards the user as away.
    double pen_hz = 133;
};

// What the tablet sends while the nib goes its way, and the nib's true places beside it.
struct PenRecording {
    std::vector<drivers::PenSample> samples {};
    std::vector<Vec2> nibs_mm {};
};
PenRecording record_pen(NibWay const& way, Holding const& holding, double seconds,
                        Tablet const& tablet, Dice& dice);

} // namespace tractus::physics
