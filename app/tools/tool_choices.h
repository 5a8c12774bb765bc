#pragma once

#include "app/tools/tool.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::tools {

// A button of bar and ring that takes a tool in hand.
struct ToolChoice {
    char const* text = ""; // The group that it stands for.
    Tool tool;             // Its first kind, or the first of the method that was in hand last.
};

// The choices that a person has first, one for each group. Tools that are `remembered`, the latest
// last, mean what they meant then.
std::vector<ToolChoice> tool_choices(ToolKinds kinds, std::span<Tool const> remembered);

// A tool of this kind as a person chooses it anew.
Tool chosen_anew(ToolKind const& kind, std::span<Tool const> remembered);

// The tool that comes to hand with a drawing: that with which the plant was made that takes what is
// drawn, as it was made; the first of all for another plant, as of a model; and the first that
// makes a plant where there is none.
Tool tool_for_drawing(ToolKinds kinds, scene::Scene const& scene);

// Both belong to the same group: to draw a branch and to redraw a part of it is to draw.
bool is_same_group(Tool const& one, Tool const& other);

// One of the things that the tool in hand may mean.
struct Meaning {
    std::string text {};       // What follows "##" is not shown: it tells buttons apart.
    Tool tool;                 // To be chosen for it.
    float width = 0;           // Of its button, at a display's scale of 1.
    bool is_on = false;        // It means that now.
    bool begins_group = false; // Of meanings that exclude each other.
    // It asks for a number, the tool's option of that number among them, and takes none in hand.
    std::optional<std::size_t> number {};
    bool opens_cards = false;     // Of the tool in hand; it takes none in hand.
    bool is_beside_glyph = false; // It is offered as long as the glyph is seen.
};

// All that tools of its group and method may mean, after the other methods of the group.
std::vector<Meaning> meanings_of(ToolKinds kinds, Tool const& hand,
                                 std::span<Tool const> remembered = {});

// "Angle 45°".
std::string describe_number(ChosenNumber const& chosen);

// "45°", "30 mm", "2".
std::string with_unit(std::string_view number, NumberOption const& option);

// As wide as a button with such a text has to be.
float button_width(std::string_view text);

} // namespace tractus::tools
