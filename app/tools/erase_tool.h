#pragma once

#include "app/tools/tool.h"

namespace tractus::tools {

// Strokes and indicators go that the stroke runs over, as the pad shows them, or parts of strokes.
struct EraseTool {
    static ToolKind const kKind;

    // How far beside a line the eraser may be and still touch it.
    static constexpr double kRadius_mm = 4;

    // What goes of a stroke. Indicators have no parts, and go whole.
    enum class Erasing {
        Whole, // All of it.
        Part,  // The tips under the eraser; all where those that are left shape nothing.
    };
    Erasing erasing = Erasing::Whole;
};

} // namespace tractus::tools
