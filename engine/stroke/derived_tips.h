#pragma once

#include "engine/base/shared_vector.h"
#include "engine/stroke/erase_tips.h"
#include "engine/stroke/tip_sample.h"

#include <vector>

namespace tractus {

// Where the tips of a stroke can be read again that was made of others: read() makes it once more
// from what they are read from (SharedVector::source()).

// Returns the source of a stroke that was redrawn in part (oversketch.h): what was drawn, and what
// over it. Null if one of them has no source.
SharedVector<TipSample>::Source redrawn_source(SharedVector<TipSample>::Source drawn,
                                               SharedVector<TipSample>::Source over);

// Returns the source of a stroke that was erased in part. Null if what was drawn has no source.
SharedVector<TipSample>::Source erased_source(SharedVector<TipSample>::Source drawn,
                                              std::vector<TipRange> ranges);

} // namespace tractus
