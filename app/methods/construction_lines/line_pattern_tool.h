#pragma once

#include "app/tools/tool.h"
#include "engine/methods/construction_lines/pattern.h"

#include <string>

namespace tractus::lines {

// Changes how the active plant's organs stand around its stem.
struct LinePatternTool {
    static tools::ToolKind const kKind;

    enum class What {
        Next,  // They have the next pattern.
        Sizes, // Sizes follow half-ellipses, or are linear again.
        Face,  // They are turned about their length.
        Rules, // The rules are the pattern's again, where somebody has written others.
    };
    What what = What::Next;
};

// Patterns that bear organs follow each other in a ring, and so do the ways to turn them: flat,
// upper side up, and down.
Pattern next_pattern(Pattern pattern);
Pattern next_face(Pattern pattern);

// What the face of organs is, for people: "lie flat", "turn their upper side up".
std::string said_of_face(Pattern const& pattern);

} // namespace tractus::lines
