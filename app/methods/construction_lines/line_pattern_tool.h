#pragma once

#include "app/tools/tool.h"
#include "engine/methods/construction_lines/pattern.h"

#include <string>

namespace tractus::lines {

// Changes how the active plant's organs are arranged around its stem.
struct LinePatternTool {
    static tools::ToolKind const kKind;

    enum class What {
        Next,  // Switches to the next pattern (phyllotaxis).
        Sizes, // Toggles how sizes change around the stem: along half-ellipses or linearly.
        Face,  // Changes how organs are rotated about their length.
        Rules, // Restores the pattern's own L-system rules if they were edited.
    };
    What what = What::Next;
};

// Return the pattern with the next choice in a ring of choices: of arrangements with organs, or of
// the organs' orientations (flat, upper side up, upper side down).
Pattern next_pattern(Pattern pattern);
Pattern next_face(Pattern pattern);

// Describes the orientation of organs for the user: "lie flat", "turn their upper side up".
std::string describe_face(Pattern const& pattern);

} // namespace tractus::lines
