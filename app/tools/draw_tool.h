#pragma once

#include "app/tools/tool.h"
#include "engine/variation/association.h"

namespace tractus::tools {

// The stroke shapes the selected branches.
struct DrawTool {
    static ToolKind const kKind;

    variation::Propagation propagation = variation::Propagation::Selected;
    variation::StrokeFit fit = variation::StrokeFit::Start;
    variation::StrokeLaying laying = variation::StrokeLaying::HeadingAndPitch;
};

// The two options that say how a stroke is laid along a branch. No button offers the second.
void visit_laying(OptionVisitor& visitor, WordOption::Offered offered, variation::StrokeFit& fit,
                  variation::StrokeLaying& laying);

} // namespace tractus::tools
