#pragma once

#include "app/tools/tool.h"

namespace tractus::tools {

// Selects branches with a stroke over the skeleton's picture.
struct SelectTool {
    static ToolKind const kKind;

    enum class SelectionMode {
        Path,   // Selects the path under the stroke.
        Ends,   // Selects everything between the branches at the stroke's two ends.
        Add,    // Adds the path to the selection.
        Take,   // Removes the path from the selection.
        Order,  // Selects all axes of the same order as the one at the stroke's end.
        Alike,  // Selects the axis at the stroke's end and all siblings like it.
        Invert, // Inverts the selection, wherever the stroke is.
        Nothing,
    };
    SelectionMode selecting = SelectionMode::Path;
};

} // namespace tractus::tools
