#pragma once

#include "app/tools/tool.h"

namespace tractus::tools {

// Selects branches with a stroke over the skeleton's picture.
struct SelectTool {
    static ToolKind const kKind;

    enum class SelectionMode {
        Path,  // Selects the path of branches under the stroke.
        Ends,  // Selects everything between the branches at the stroke's two ends.
        Add,   // Adds the path under the stroke to the selection.
        Take,  // Removes the path under the stroke from the selection.
        Order, // Selects all axes of the same order as the axis at the stroke's end.
        // Selects the axis at the stroke's end and its similar siblings (similar_siblings()).
        Alike,
        Invert, // Inverts the selection, regardless of the stroke.
        Nothing,
    };
    SelectionMode selecting = SelectionMode::Path;
};

} // namespace tractus::tools
