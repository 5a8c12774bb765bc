#pragma once

#include "tests/physics/potentiometer.h"

#include <string>
#include <vector>

namespace tractus::physics {

// A person who sets the table to heights by a ruler, one capture after another.
struct Person {
    std::vector<double> heights_mm {}; // Where the table goes …
    std::vector<double> told_mm {};    // … and what is typed there, without the ruler's error.
    double ruler_error_mm = 0.3;
};

// The recording of a height calibration, in the log format that `tractus calibrate height LOG`
// reads, with a slider of HID as the sensor.
std::string capture_log(Potentiometer const& sensor, int full_scale, Person const& person,
                        Dice& dice);

} // namespace tractus::physics
