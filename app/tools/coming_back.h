#pragma once

#include "engine/stroke/tip_sample.h"

#include <span>

namespace tractus::tools {

// True if the pen is on its way back to the start of a closed line, so that the rest of the line
// can be guessed. `ink` has at least one tip.
bool is_coming_back(std::span<TipSample const> ink);

} // namespace tractus::tools
