#pragma once

#include "engine/base/result.h"
#include "engine/base/time.h"

#include <string_view>

namespace tractus::calib {

// The assumed height of the carriage during a log that has no height sensor, so that the recording
// of a tablet on a desk also becomes strokes in space. Deterministic.
//
// The named scenarios span 50 to 350 mm, the usual travel of a station. With p the elapsed share of
// the log, 0 at its first pen sample and 1 at its last, and t the seconds since the first:
//
//     rise   50 + 300 p                     up at a constant speed
//     fall   350 - 300 p                    down
//     arch   50 + 300 sin(pi p)             up and back
//     sway   200 + 150 sin(2 pi t / 8 s)    up and down repeatedly, at most 118 mm/s
struct HeightScenario {
    enum class Kind {
        Constant,
        Rise,
        Fall,
        Arch,
        Sway,
    };
    Kind kind = Kind::Constant;
    double constant_mm = 0; // Height of the Constant kind.
};

// Parses a scenario's name, such as "arch", or a number of millimetres. Fails with a user error.
Result<HeightScenario> parse_height_scenario(std::string_view text);

// Returns the height at `since_first` after a log's first pen sample. Times before the first and
// after the last sample give the height at that sample. `length` is the time from the first to the
// last sample; if it is zero, the height is that of the first.
double height_mm(HeightScenario const& scenario, Duration since_first, Duration length);

} // namespace tractus::calib
