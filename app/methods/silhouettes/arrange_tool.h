#pragma once

#include "app/tools/tool.h"

namespace tractus::silhouette {

// Arranges the branches of the active tree, which was drawn by its outline, in another pattern.
struct ArrangeTool {
    static tools::ToolKind const kKind;

    enum class To { Next, Even, Spiral, Decussate, Whorls, TwoRows, Horizontal } to = To::Next;
    enum class Around { Trunk, Branches } around = Around::Trunk;
    double whorl = 3; // Branches at a node, where they come to stand in whorls.
};

} // namespace tractus::silhouette
