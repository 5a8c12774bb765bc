#pragma once

#include "engine/base/vectors.h"
#include "engine/scene/scene.h"

#include <span>
#include <vector>

namespace tractus::tools {

class Tool;

// Appearance of a layer's lines. Layers shown together differ in colour and pattern, so that they
// can be told apart without colours.
struct LayerStyle {
    enum class Color { Orange, Blue, Green, Purple, Grey } color = Color::Grey;
    enum class Pattern { Solid, Dashed, Dotted } pattern = Pattern::Solid;
    enum class End { Plain, Arrow } end = End::Plain;
    double width_mm = 1.5; // Line width on the tablet.
};

// Lines shown with the active plant, on the tablet and with the skeleton: drawn for the plant, or
// inferred from the drawing. Views show the layers of a list and know none of them by name.
struct Layer {
    char const* label; // Name in the skeleton's legend, in lower case: "leaning".
    LayerStyle style {};
    // Returns the lines, each of at least two points, in the world frame. Called when the plant has
    // changed.
    std::vector<std::vector<Vec3f>> (*lines)(scene::BuiltPlant const& plant);
    // When the layer is visible: always, for some seconds after its lines have changed, or only
    // while the current tool asks for it.
    enum class Seen { Always, AWhile, WhenAskedFor } seen = Seen::Always;
    // True while the current tool asks for the layer. Null: never.
    bool (*is_asked_for)(Tool const& in_hand) = nullptr;
};

// The program's layers in drawing order.
using Layers = std::span<Layer const* const>;

} // namespace tractus::tools
