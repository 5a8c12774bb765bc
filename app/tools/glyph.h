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

// A small drawing of what a tool's options mean, with points on it by which they are set. Its frame
// is a square from -1 to 1, x to the right and y up.
struct Glyph {
    struct Line {
        std::vector<Vec2> points;
        double width = 0.02;
        LayerStyle::Color color = LayerStyle::Color::Grey;
    };
    struct Handle {
        std::size_t id = 0; // The same wherever the handle is.
        Vec2 place = Vec2::Zero();
        std::string says {};    // What it sets, and its value, for people.
        char const* sign = "";  // Written on it.
        bool is_button = false; // It is pressed and not dragged.
        // The number among the options that is asked for when the handle is pressed and not
        // dragged; empty: none.
        char const* number = "";
        bool is_small = false; // One of many.
    };
    struct Label {
        Vec2 place = Vec2::Zero(); // Middle of its upper edge.
        char const* text = "";
    };
    std::vector<Line> lines;
    std::vector<Handle> handles;
    std::vector<Label> labels {};       // Left out where there is no room.
    char const* hint = "Drag a letter"; // Shown as long as nothing is pointed at.
};

// How a kind of tool shows its options so. Called once a frame, with options of its kind.
struct GlyphKind {
    char const* title;
    Glyph (*show)(void const* options);
    // A person drags a handle to a place, or presses it. Options stay within their ranges.
    void (*drag)(void* options, std::size_t handle, Vec2 const& to);
};

// How a kind of tool shows a drawing of what has been drawn with it, in the same frame: numbers of
// the active plant, which are set there.
struct DrawnGlyphKind {
    char const* title;
    // No value where the active plant has none. Called when the plant has changed.
    std::optional<Glyph> (*show)(scene::Scene const& scene);
    // What it means that a person drags a handle to a place, or presses it: edits of the scene.
    // Fails, as the user's fault, where that cannot be.
    Result<std::vector<scene::Edit>> (*drag)(scene::Scene const& scene, std::size_t handle,
                                             Vec2 const& to);
};

} // namespace tractus::tools
