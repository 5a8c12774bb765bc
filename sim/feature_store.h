#pragma once

#include "sim/uhid_device.h"

namespace tractus::sim {

// Answers as most devices do that are asked for nothing in particular: a feature report is what it
// was last set to, and the id alone before that. The kernel's drivers read a mode that they have
// set back, to see that it was taken.
UhidAnswers remember_features();

} // namespace tractus::sim
