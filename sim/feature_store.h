#pragma once

#include "sim/uhid_device.h"

namespace tractus::sim {

// Returns functions that answer feature requests as most devices do: a feature report is as it was
// last set; before that it consists only of its id. The kernel's drivers read back a mode that they
// have set, to check that it was accepted.
UhidAnswers remember_features();

} // namespace tractus::sim
