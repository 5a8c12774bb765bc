#pragma once

#include "app/tools/tool.h"

namespace tractus::lines {

// Changes the organs of the layer beside which the stroke ends, so that one stem can have both
// leaves and flowers.
struct LayerOrgansTool {
    static tools::ToolKind const kKind;

    enum class What {
        Organ,   // Switches to the plant's next kind of organ, or to plain leaves.
        Pattern, // Switches to the next arrangement (phyllotaxis) of the organs.
        Face,    // Changes how the organs are rotated about their length.
        // Uses the leaf on whose lines the stroke begins, or copies of the plant there, as organs.
        Plant,
    };
    What what = What::Organ;
};

} // namespace tractus::lines
