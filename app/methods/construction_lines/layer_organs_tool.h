#pragma once

#include "app/tools/tool.h"

namespace tractus::lines {

// Changes what the layer of a sketch bears beside which the stroke ends, so that leaves and flowers
// may be on one stem.
struct LayerOrgansTool {
    static tools::ToolKind const kKind;

    enum class What {
        Organ,   // What its organs are: the next of the plant's, or plain leaves.
        Pattern, // How they stand: the next pattern.
        Face,    // How they are turned.
        Plant,   // The leaf, or plants like the one, on whose lines the stroke begins.
    };
    What what = What::Organ;
};

} // namespace tractus::lines
