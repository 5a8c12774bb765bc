#pragma once

#include "engine/base/shared_vector.h"
#include "engine/stroke/tip_sample.h"

namespace tractus {

// A stroke of the pen from pen-down to pen-up: its tips in time order, all of them touching and
// with settled heights. World frame. Copies share the tips, since a stroke is kept in many places:
// in the edit that it was drawn by, and in every scene from there on.
struct Stroke {
    SharedVector<TipSample> tips;
};

} // namespace tractus
