#pragma once

#include "app/tools/layer.h"

namespace tractus {

// What was drawn of the active tree, where it stands: its crown's outline,
extern Layer const kOutlineLayer;
// and its trunk and branches.
extern Layer const kTrunkLayer;

} // namespace tractus
