#pragma once

#include "engine/stroke/tip_sample.h"

#include <vector>

namespace tractus {

// What a hand drew from pen-down to pen-up: its tips in time order, all of them touching and with
// settled heights. World frame.
struct Stroke {
    std::vector<TipSample> tips;
};

} // namespace tractus
