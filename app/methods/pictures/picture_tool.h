#pragma once

#include "app/tools/tool_kind.h"

namespace tractus::pictures {

// Moves, scales or rotates the picture behind the drawing as the stroke says, locks the picture, or
// removes it (back_picture.h). Strokes can also place the ground in the picture: a horizontal
// stroke marks the horizon, and a vertical stroke an object of known height (picture_ground.h).
struct PictureTool {
    static tools::ToolKind const kKind;

    enum class Does { Move, Size, Turn, Ground, Lock, Remove } does = Does::Move;
    double strength_percent = 50;
    double height_m = 1.8; // Height of the object that a vertical stroke marks.

    bool operator==(PictureTool const&) const = default;
};

} // namespace tractus::pictures
