#pragma once

#include "engine/base/vectors.h"
#include "engine/scene/scene.h"

#include <span>
#include <vector>

namespace tractus::tools {

class Tool;

// How the lines of a layer look. Layers that are seen together differ in colour and in pattern, so
// that nobody needs the colours.
struct LayerStyle {
    enum class Color { Orange, Blue, Green, Purple, Grey } color = Color::Grey;
    enum class Pattern { Solid, Dashed, Dotted } pattern = Pattern::Solid;
    enum class End { Plain, Arrow } end = End::Plain;
    double width_mm = 1.5; // On the pad.
};

// Lines that are shown with the active plant, on the pad and with the skeleton: what was drawn for
// the plant, or is inferred from that. A row of a list: the views know no layer by name.
struct Layer {
    char const* label; // In the skeleton's legend, in small letters: "leaning".
    LayerStyle style {};
    // The lines, each of at least two points. World frame. Called when the plant has changed.
    std::vector<std::vector<Vec3f>> (*lines)(scene::BuiltPlant const& plant);
    // When they are seen: always, for some seconds after they have changed, or neither; and as long
    // as the tool in hand asks for them.
    enum class Seen { Always, AWhile, WhenAskedFor } seen = Seen::Always;
    bool (*is_asked_for)(Tool const& in_hand) = nullptr; // No value: it never is.
};

// The layers that a program has, in the order in which they are drawn.
using Layers = std::span<Layer const* const>;

} // namespace tractus::tools
