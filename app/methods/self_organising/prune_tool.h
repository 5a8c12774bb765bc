#pragma once

#include "app/tools/tool.h"

namespace tractus::self_organising {

// Prunes the active self-organising tree with a spherical brush, or takes back space that the
// growth brush has swept for it. While the growth brush is selected, the pen's other end is this
// tool.
struct PruneTool {
    static tools::ToolKind const kKind;

    enum class What { Prune, Clear } what = What::Prune;
    double min_radius_mm = 2;  // Radius of the brush on the desk at zero pressure.
    double most_radius_mm = 8; // Radius of the brush on the desk at full pressure.
};

} // namespace tractus::self_organising
