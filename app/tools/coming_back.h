#pragma once

#include "engine/stroke/tip_sample.h"

#include <span>

namespace tractus::tools {

// True if enough of a closed line was drawn that the rest can be guessed, as the pen is on its way
// back to the start. `ink` has at least one tip.
bool is_coming_back(std::span<TipSample const> ink);

} // namespace tractus::tools
