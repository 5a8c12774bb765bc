#pragma once

#include "app/tools/tool.h"
#include "engine/methods/construction_lines/pattern.h"

#include <string>

namespace tractus::lines {

// Changes how the organs of the active plant are arranged around their stem.
struct LinePatternTool {
    static tools::ToolKind const kKind;

    enum class What {
        Next,  // Gives the organs the next pattern (phyllotaxis).
        Sizes, // Switches how sizes change around the stem: along half-ellipses or linearly.
        Face,  // Changes how the organs are rotated about their length.
        Rules, // Restores the L-system rules that belong to the pattern, if they were edited.
    };
    What what = What::Next;
};

// Return the pattern with the next of several choices; the first follows the last. next_pattern()
// changes the arrangement of organs, next_face() how they are rotated (flat, upper side up, or
// upper side down).
Pattern next_pattern(Pattern pattern);
Pattern next_face(Pattern pattern);

// Describes to the user how the pattern rotates organs: "lie flat", "turn their upper side up".
std::string describe_face(Pattern const& pattern);

} // namespace tractus::lines
