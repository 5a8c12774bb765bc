#pragma once

#include "tests/physics/potentiometer.h"

#include <string>
#include <vector>

namespace tractus::physics {

// A person who sets the table to heights with a ruler, one capture after another.
struct Person {
    std::vector<double> heights_mm {}; // Heights to which the table is set.
    std::vector<double> stated_mm {};  // Heights that the person types, without the ruler's error.
    double ruler_error_mm = 0.3;
};

// Returns the recording of a height calibration with a HID slider as the sensor, in the log format
// that `tractus calibrate height LOG` reads.
std::string capture_log(Potentiometer const& sensor, int full_scale, Person const& person,
                        Dice& dice);

} // namespace tractus::physics
