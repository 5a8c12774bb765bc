#pragma once

#include "app/tools/tool.h"

namespace tractus::lines {

// Changes the organs of the layer of a sketch beside which the stroke ends. So a stem can have, for
// example, both leaves and flowers.
struct LayerOrgansTool {
    static tools::ToolKind const kKind;

    enum class What {
        // Gives the layer the next of the plant's kinds of organs; plain leaves follow the last.
        Organ,
        Pattern, // Gives the layer's organs the next arrangement (phyllotaxis).
        Face,    // Changes how the layer's organs are rotated about their length.
        // Gives the layer as organs the leaf on whose lines the stroke begins, or copies of the
        // other plant on whose lines it begins.
        Plant,
    };
    What what = What::Organ;
};

} // namespace tractus::lines
