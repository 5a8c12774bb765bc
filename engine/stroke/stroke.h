#pragma once

#include "engine/base/shared_vector.h"
#include "engine/stroke/tip_sample.h"

namespace tractus {

// A stroke of the pen from pen-down to pen-up: its tips in time order, all touching the tablet and
// with final heights. World frame. Copies share the tips, since a stroke is kept in many places: in
// the edit that created it and in every later scene.
struct Stroke {
    SharedVector<TipSample> tips;
};

} // namespace tractus
