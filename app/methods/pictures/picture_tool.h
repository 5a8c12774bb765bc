#pragma once

#include "app/tools/tool_kind.h"

namespace tractus::pictures {

// Moves, sizes and turns the picture behind what is drawn along with the stroke, locks it where it
// lies, and takes it away (back_picture.h); or a level stroke says where the picture's horizon is,
// an upright one where something of a known height stands (picture_ground.h).
struct PictureTool {
    static tools::ToolKind const kKind;

    enum class Does { Move, Size, Turn, Ground, Lock, Remove } does = Does::Move;
    double strength_percent = 50;
    double height_m = 1.8; // The known one.

    bool operator==(PictureTool const&) const = default;
};

} // namespace tractus::pictures
