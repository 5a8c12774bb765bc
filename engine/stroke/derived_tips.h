#pragma once

#include "engine/base/shared_vector.h"
#include "engine/stroke/erase_tips.h"
#include "engine/stroke/tip_sample.h"

#include <vector>

namespace tractus {

// Sources of strokes that were computed from other strokes. Their read() recomputes the tips from
// the sources of those other strokes (SharedVector::source()).

// Returns the source of a stroke that was partly redrawn (oversketch.h): `drawn` is the source of
// the original stroke, `over` that of the stroke drawn over it. Returns null if either source is
// null.
SharedVector<TipSample>::Source redrawn_source(SharedVector<TipSample>::Source drawn,
                                               SharedVector<TipSample>::Source over);

// Returns the source of a stroke from which `ranges` were erased, where `drawn` is the source of
// the original stroke. Returns null if `drawn` is null.
SharedVector<TipSample>::Source erased_source(SharedVector<TipSample>::Source drawn,
                                              std::vector<TipRange> ranges);

// Returns the source of a stroke that was reversed (reversed_tips()), where `drawn` is the source
// of the original stroke. Returns null if `drawn` is null.
SharedVector<TipSample>::Source reversed_source(SharedVector<TipSample>::Source drawn);

// Returns the tips in reverse order, with their times in the original order.
std::vector<TipSample> reversed_tips(std::vector<TipSample> tips);

} // namespace tractus
