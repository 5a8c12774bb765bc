#pragma once

#include "app/tools/tool_kind.h"

namespace tractus::pictures {

// Moves, scales or rotates the picture behind the drawing along with the stroke, locks it, or
// removes it (back_picture.h). To place the ground, a horizontal stroke marks the picture's horizon
// and a vertical one an object of known height (picture_ground.h).
struct PictureTool {
    static tools::ToolKind const kKind;

    enum class Does { Move, Size, Turn, Ground, Lock, Remove } does = Does::Move;
    double strength_percent = 50;
    double height_m = 1.8; // Height of the marked object.

    bool operator==(PictureTool const&) const = default;
};

} // namespace tractus::pictures
