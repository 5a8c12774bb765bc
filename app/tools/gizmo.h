#pragma once

#include "app/tools/layer.h"
#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/scene/edit_kind.h"
#include "engine/scene/scene.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tractus::tools {

// A gizmo: a small drawing of a tool's options, with handles that set them. Coordinates are in a
// square from -1 to 1, x to the right and y up.
struct Gizmo {
    struct Line {
        std::vector<Vec2> points;
        double width = 0.02;
        LayerStyle::Color color = LayerStyle::Color::Grey;
    };
    struct Handle {
        std::size_t id = 0; // Identifies the handle, also after it has moved.
        Vec2 place = Vec2::Zero();
        std::string says {};    // Text for the user: what the handle sets, and its value.
        char const* sign = "";  // Letter written on the handle.
        bool is_button = false; // The handle is pressed rather than dragged.
        // Name of the number option whose value the program asks for when the handle is pressed
        // rather than dragged; empty: none.
        char const* number = "";
        bool is_small = false; // True: drawn smaller, for a gizmo with many handles.
    };
    struct Label {
        Vec2 place = Vec2::Zero(); // Middle of the text's upper edge.
        char const* text = "";
    };
    std::vector<Line> lines;
    std::vector<Handle> handles;
    std::vector<Label> labels {};       // Texts in the gizmo, left out where it is drawn too small.
    char const* hint = "Drag a letter"; // Text shown while the pointer is not on a handle.
};

// Gizmo that sets the options of a kind of tool. `options` points to options of that kind. Both
// functions are called at most once per frame.
struct GizmoKind {
    char const* title;
    Gizmo (*show)(void const* options);
    // Applies the user's drag or press of a handle to the options, which stay within their ranges.
    void (*drag)(void* options, std::size_t handle, Vec2 const& to);
};

// Gizmo that edits the numbers of the active plant, if the plant was drawn with this kind of tool.
// Coordinates are those of Gizmo.
struct DrawnGizmoKind {
    char const* title;
    // Returns the gizmo, or no value if the active plant has no numbers to edit. Called when the
    // plant has changed.
    std::optional<Gizmo> (*show)(scene::Scene const& scene);
    // Edits for the user's drag or press of a handle. Fails with a user error if the plant cannot
    // be changed in this way.
    Result<std::vector<scene::Edit>> (*drag)(scene::Scene const& scene, std::size_t handle,
                                             Vec2 const& to);
};

} // namespace tractus::tools
