#pragma once

#include "app/tools/methods.h"
#include "app/tools/tool.h"
#include "engine/stroke/stroke.h"

namespace tractus::methods {

// A minimal method, a gust of wind along a stroke, that has every kind of component: an edit, a
// tool and a layer. It exists only in tests, to show that a method can be added without changing
// the program.

// Edit that leans the plant in a stroke's direction, by a multiple of the stroke's length.
struct BlowGust {
    static scene::EditKind const kKind;

    Stroke stroke;
    double strength = 1;
};

// Tool that draws a gust.
struct GustTool {
    static tools::ToolKind const kKind;

    enum class Towards { End, Start };
    Towards towards = Towards::End;
    double strength = 1; // Multiple of the stroke's length, from 0.1 to 5.
};

// Layer that shows how far the gusts reach.
extern tools::Layer const kGustLayer;

// Returns all methods of the program and the gust.
tools::Methods methods_with_gust();

} // namespace tractus::methods
