#pragma once

#include "engine/stroke/tip_sample.h"

#include <span>

namespace tractus::tools {

// Whether so much of a closed line is drawn that the rest can be guessed: the pen is on its way
// back to where it began. `ink`: at least one tip.
bool is_coming_back(std::span<TipSample const> ink);

} // namespace tractus::tools
