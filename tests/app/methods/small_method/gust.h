#pragma once

#include "app/tools/methods.h"
#include "app/tools/tool.h"
#include "engine/stroke/stroke.h"

namespace tractus::methods {

// A method as small as one can be that has a bit of everything: a gust of wind along a stroke. Only
// here, to show what the seam takes without a change of the program.

// The edit: leans the plant along a stroke, so many times as far as that goes.
struct BlowGust {
    static scene::EditKind const kKind;

    Stroke stroke;
    double strength = 1;
};

// The tool that draws it.
struct GustTool {
    static tools::ToolKind const kKind;

    enum class Towards { End, Start };
    Towards towards = Towards::End;
    double strength = 1; // 0.1 to 5.
};

// The layer that shows how far the gusts reach.
extern tools::Layer const kGustLayer;

// The program's methods and this one.
tools::Methods methods_with_gust();

} // namespace tractus::methods
