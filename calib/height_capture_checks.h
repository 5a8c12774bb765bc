#pragma once

#include "calib/height_capture.h"
#include "engine/base/result.h"

#include <span>

namespace tractus::calib {

// Checks the conditions for fitting any model. Fails with a user error that says what to do, for:
// fewer than two captures; heights that all lie within 20 mm; readings that stay the same while the
// ruler changes; readings whose order contradicts that of the heights (except for one capture in
// five, which may have slipped).
Result<void> check_captures(std::span<HeightCapture const> captures);

// Returns how many out of `captures` captures may be left out as slipped: one in five, at least
// one.
std::size_t max_slips(std::size_t captures);

} // namespace tractus::calib
