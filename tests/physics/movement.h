#pragma once

#include "calib/rig.h"
#include "tests/physics/potentiometer.h"

#include <functional>
#include <vector>

namespace tractus::physics {

// A table that moves under a pen, and the samples of the pen and of the height sensor. The sensor's
// string is vertical: a millimetre is ten counts of 4096.

// Returns the table's height in millimetres at a time in seconds.
using Movement = std::function<double(double seconds)>;

struct Sampling {
    double seconds = 4;
    double height_hz = 500;
    double pen_hz = 133;
    double noise_counts = 1;
    double gap_from_s = 0; // Beginning of a gap without readings.
    double gap_to_s = 0;   // End of the gap without readings.
    double spike_part = 0; // Share of isolated readings that are off by 30 mm.
    // Interval of bursts in which readings and pen samples arrive together. 0: they arrive one by
    // one.
    double burst_s = 0;
    // If greater than burst_s, the interval of each burst is random between the two.
    double most_burst_s = 0;
    double lost_part = 0;         // Share of readings and pen samples that are lost.
    bool pens_come_first = false; // True: within a burst, pen samples precede the readings.
    calib::SampleTimes sample_times = calib::SampleTimes::AsArrived;
};

// The tip that the program makes from a pen sample.
struct Tip {
    double seconds = 0; // Time at which the pen was there.
    double error_mm = 0;
    bool is_extrapolated = false;
};

struct Tips {
    std::vector<Tip> live {};
    std::vector<Tip> settled {};
};

// Pushes both devices' samples through the program's fuser in order of arrival.
Tips fuse(Movement const& movement, Sampling const& sampling, Dice& dice);

// Returns the movement of a hand that sways the table about 200 mm with a maximum speed.
Movement sway(double speed_mm_per_s);

// Returns a movement that rises at a constant speed for a second, and then stops within
// `stopping_s`.
Movement stop(double speed_mm_per_s, double stopping_s);

} // namespace tractus::physics
