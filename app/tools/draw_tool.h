#pragma once

#include "app/tools/stroke_base.h"
#include "app/tools/tool.h"
#include "engine/variation/association.h"

namespace tractus::tools {

// Gives the selected branches the shape of the stroke.
struct DrawTool {
    static ToolKind const kKind;

    variation::Propagation propagation = variation::Propagation::Selected;
    variation::StrokeFit fit = variation::StrokeFit::Start;
    variation::StrokeLaying laying = variation::StrokeLaying::HeadingAndPitch;
    StrokeBase base = StrokeBase::AtFoot;
};

// Visits the options for how a stroke is laid along a branch: `fit`, whose words are offered as
// `offered` says, and `laying`, which has no button.
void visit_laying(OptionVisitor& visitor, WordOption::Offered offered, variation::StrokeFit& fit,
                  variation::StrokeLaying& laying);

} // namespace tractus::tools
