#pragma once

#include "app/tools/tool.h"

namespace tractus::tools {

// The stroke runs over the skeleton's picture and chooses branches.
struct SelectTool {
    static ToolKind const kKind;

    enum class Selecting {
        Path,   // The path under the stroke.
        Ends,   // All between the branches under the stroke's two ends.
        Add,    // The path as well.
        Take,   // What was chosen but for the path.
        Order,  // All axes of the order of the one under the stroke's end.
        Alike,  // That axis and all siblings that are like it.
        Invert, // What was not chosen; wherever the stroke is.
        Nothing,
    };
    Selecting selecting = Selecting::Path;
};

} // namespace tractus::tools
