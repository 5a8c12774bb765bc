#pragma once

#include "app/tools/layer.h"

namespace tractus {

// The motion indicators of the active plant, as arrows.
extern Layer const kIndicatorLayer;

} // namespace tractus
