#pragma once

#include "app/tools/tool.h"

namespace tractus::silhouette {

// Arranges the branches of the active tree, which was drawn by its outline, in another pattern
// (phyllotaxis).
struct ArrangeTool {
    static tools::ToolKind const kKind;

    enum class To { Next, Even, Spiral, Decussate, Whorls, TwoRows, Horizontal } to = To::Next;
    enum class Around { Trunk, Branches } around = Around::Trunk;
    double whorl = 3; // Branches per node, if the new pattern is whorls.
};

} // namespace tractus::silhouette
