#pragma once

#include "app/tools/tool_kind.h"

namespace tractus {

// Moves, sizes and turns the picture behind what is drawn along with the stroke, locks it where it
// lies, and takes it away (back_picture.h).
struct PictureTool {
    static ToolKind const kKind;

    enum class Does { Move, Size, Turn, Lock, Remove } does = Does::Move;
    double strength_percent = 50;

    bool operator==(PictureTool const&) const = default;
};

} // namespace tractus
