#pragma once

#include "sim/uhid_device.h"

namespace tractus::sim {

// Returns answers as most devices give them: a feature report is what it was last set to, and only
// its id before that. The kernel's drivers read back a mode that they have set, to check that it
// was accepted.
UhidAnswers remember_features();

} // namespace tractus::sim
