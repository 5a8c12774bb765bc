#pragma once

#include "calib/rig.h"
#include "tests/physics/potentiometer.h"

#include <functional>
#include <vector>

namespace tractus::physics {

// A table that moves under a pen, and what the two devices of a plumb rig send of it: a millimetre
// is ten counts of 4096.

// The table's height in millimetres after so many seconds.
using Movement = std::function<double(double seconds)>;

struct Sampling {
    double seconds = 4;
    double height_hz = 500;
    double pen_hz = 133;
    double noise_counts = 1;
    double gap_from_s = 0;   // No readings come from here …
    double gap_to_s = 0;     // … to here.
    double spike_part = 0;   // Share of the readings that are off by 30 mm, alone.
    double burst_s = 0;      // Readings and pen samples come together, so often; 0: as they are.
    double most_burst_s = 0; // Greater: each burst at random from burst_s to this.
    double lost_part = 0;    // Share of the readings and pen samples that are lost.
    bool pens_come_first = false; // Of what comes together, before the readings.
    calib::SampleTimes sample_times = calib::SampleTimes::AsArrived;
};

// Result of the program for a pen sample.
struct Tip {
    double seconds = 0; // When the pen was there.
    double error_mm = 0;
    bool is_extrapolated = false;
};

struct Tips {
    std::vector<Tip> live {};
    std::vector<Tip> settled {};
};

// Pushes both devices' samples through the program's fuser as they come.
Tips fuse(Movement const& movement, Sampling const& sampling, Dice& dice);

// A hand that sways the table about 200 mm with a greatest speed.
Movement sway(double speed_mm_per_s);

// Rises at a speed for a second and stops within `stopping_s`.
Movement stop(double speed_mm_per_s, double stopping_s);

} // namespace tractus::physics
