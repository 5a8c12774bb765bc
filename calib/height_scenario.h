#pragma once

#include "engine/base/result.h"
#include "engine/base/time.h"

#include <string_view>

namespace tractus::calib {

// How high the carriage was during a log that has no height sensor: somebody's recording of a
// tablet that lay flat on a desk still becomes strokes in space. Deterministic.
//
// The named ones span 50 to 350 mm, which is what a tractus travels. With p the part of the log
// that has passed, 0 at its first pen sample and 1 at its last, and t the seconds since the first:
//
//     rise   50 + 300 p                     up at one speed, whatever the log's length
//     fall   350 - 300 p                    down
//     arch   50 + 300 sin(pi p)             up and back
//     sway   200 + 150 sin(2 pi t / 8 s)    up and down for as long as it takes, at most 118 mm/s
struct HeightScenario {
    enum class Kind {
        Constant,
        Rise,
        Fall,
        Arch,
        Sway,
    };
    Kind kind = Kind::Constant;
    double constant_mm = 0; // Height for Constant alone.
};

// A scenario's name as above, or a number of millimetres. Fails as the user's fault.
Result<HeightScenario> parse_height_scenario(std::string_view text);

// The height at `since_first` after a log's first pen sample. Times before the first and after the
// last sample give the height at that sample. `length` is the time from first to last; where it is
// zero, p is 0.
double height_mm(HeightScenario const& scenario, Duration since_first, Duration length);

} // namespace tractus::calib
