#pragma once

#include "app/tools/tool.h"

namespace tractus::lines {

// Changes how the active plant's organs stand around its stem.
struct LinePatternTool {
    static tools::ToolKind const kKind;

    enum class What {
        Next,  // They have the next pattern.
        Sizes, // Sizes follow half-ellipses, or are linear again.
    };
    What what = What::Next;
};

} // namespace tractus::lines
