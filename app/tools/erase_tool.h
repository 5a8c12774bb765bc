#pragma once

#include "app/tools/tool.h"

namespace tractus::tools {

// Erases strokes and indicators that the eraser crosses as seen on the tablet, or only the crossed
// parts of strokes.
struct EraseTool {
    static ToolKind const kKind;

    // Radius of the eraser around the path of its stroke.
    static constexpr double kRadius_mm = 4;

    // How much of a stroke is erased. Indicators are always erased whole.
    enum class EraseExtent {
        Whole, // Erases the whole stroke.
        // Erases only the tips under the eraser, or the whole stroke if the rest would shape
        // nothing.
        Part,
    };
    EraseExtent erasing = EraseExtent::Whole;
};

} // namespace tractus::tools
