#pragma once

#include "app/tools/tool.h"
#include "engine/variation/association.h"

namespace tractus::tools {

// The stroke shapes the selected branches.
struct DrawTool {
    static ToolKind const kKind;

    variation::Propagation propagation = variation::Propagation::Selected;
    variation::StrokeFit fit = variation::StrokeFit::Start;
};

} // namespace tractus::tools
