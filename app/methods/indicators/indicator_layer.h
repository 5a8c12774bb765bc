#pragma once

#include "app/tools/layer.h"

namespace tractus::indicators {

// Layer that shows the motion indicators of the active plant as arrows.
extern tools::Layer const kIndicatorLayer;

} // namespace tractus::indicators
