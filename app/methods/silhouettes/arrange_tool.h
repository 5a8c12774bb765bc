#pragma once

#include "app/tools/tool.h"

namespace tractus::silhouette {

// Arranges the branches of the active tree in another pattern (phyllotaxis), if the tree was drawn
// by its outline.
struct ArrangeTool {
    static tools::ToolKind const kKind;

    enum class To { Next, Even, Spiral, Decussate, Whorls, TwoRows, Horizontal } to = To::Next;
    enum class Around { Trunk, Branches } around = Around::Trunk;
    double whorl = 3; // Number of branches per node, if the new pattern has whorls.
};

} // namespace tractus::silhouette
