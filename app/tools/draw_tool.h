#pragma once

#include "app/tools/tool.h"
#include "engine/variation/association.h"

namespace tractus::tools {

// Shapes the selected branches like the stroke.
struct DrawTool {
    static ToolKind const kKind;

    variation::Propagation propagation = variation::Propagation::Selected;
    variation::StrokeFit fit = variation::StrokeFit::Start;
    variation::StrokeLaying laying = variation::StrokeLaying::HeadingAndPitch;
};

// Visits the two options that control how a stroke is laid along a branch. The second has no
// button.
void visit_laying(OptionVisitor& visitor, WordOption::Offered offered, variation::StrokeFit& fit,
                  variation::StrokeLaying& laying);

} // namespace tractus::tools
