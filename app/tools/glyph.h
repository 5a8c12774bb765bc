#pragma once

#include "app/tools/layer.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tractus {

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
    };
    std::vector<Line> lines;
    std::vector<Handle> handles;
};

// How a kind of tool shows its options so. Called once a frame, with options of its kind.
struct GlyphKind {
    char const* title;
    Glyph (*show)(void const* options);
    // A person drags a handle to a place, or presses it. Options stay within their ranges.
    void (*drag)(void* options, std::size_t handle, Vec2 const& to);
};

} // namespace tractus
