#pragma once

#include "app/tools/stroke_base.h"
#include "app/tools/tool.h"
#include "engine/variation/association.h"

namespace tractus::tools {

// Each stroke shapes the next axis in the plant's drawing order, starting with the trunk.
struct DrawInOrderTool {
    static ToolKind const kKind;

    variation::StrokeFit fit = variation::StrokeFit::Start;
    variation::StrokeLaying laying = variation::StrokeLaying::HeadingAndPitch;
    StrokeBase base = StrokeBase::AtFoot;
};

} // namespace tractus::tools
