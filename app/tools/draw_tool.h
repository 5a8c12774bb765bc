#pragma once

#include "app/tools/tool.h"
#include "engine/variation/association.h"

namespace tractus {

// The stroke shapes the selected branches.
struct DrawTool {
    static ToolKind const kKind;

    Propagation propagation = Propagation::Selected;
    StrokeFit fit = StrokeFit::Start;
};

} // namespace tractus
