#pragma once

#include "app/tools/tool.h"

namespace tractus::lines {

// Changes what the layer of a sketch bears beside which the stroke ends, so that leaves and flowers
// may be on one stem.
struct LayerOrgansTool {
    static tools::ToolKind const kKind;

    enum class What {
        Pattern, // How its organs stand: the next pattern.
        Face,    // How they are turned.
        Organ,   // What they are: the next of the plant's organs, or plain leaves.
        Plant,   // Plants like the one on whose lines the stroke begins.
    };
    What what = What::Pattern;
};

} // namespace tractus::lines
