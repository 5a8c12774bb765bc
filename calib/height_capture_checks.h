#pragma once

#include "calib/height_capture.h"
#include "engine/base/result.h"

#include <span>

namespace tractus::calib {

// Checks what captures must be before any model can be fitted to them. Fails, as the user's fault,
// with what to do, for: fewer than two captures, heights within 20 mm, readings that stay the same
// while the ruler changes, heights whose order cannot be told from the readings' (but for captures
// that may have slipped, one in five).
Result<void> check_captures(std::span<HeightCapture const> captures);

// How many of some captures may be left out as slipped: one in five, at least one.
std::size_t most_slips(std::size_t captures);

} // namespace tractus::calib
