#pragma once

#include "app/tools/tool.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// A button of bar and ring that takes a tool in hand.
struct ToolChoice {
    char const* text = ""; // The group that it stands for.
    Tool tool;             // Its first kind.
};

// Those among which a person chooses first. Tools that are `remembered` mean what they meant last.
std::vector<ToolChoice> tool_choices(ToolKinds kinds, std::span<Tool const> remembered);

// A tool of this kind as a person chooses it anew.
Tool chosen_anew(ToolKind const& kind, std::span<Tool const> remembered);

// Both belong to the same group: to draw a branch and to redraw a part of it is to draw.
bool is_same_group(Tool const& one, Tool const& other);

// One of the things that the tool in hand may mean.
struct Meaning {
    std::string text {};       // What follows "##" is not shown: it tells buttons apart.
    Tool tool;                 // To be chosen for it.
    float width = 0;           // Of its button, at a display's scale of 1.
    bool is_on = false;        // It means that now.
    bool begins_group = false; // Of meanings that exclude each other.
};

// All that tools of its group may mean.
std::vector<Meaning> meanings_of(ToolKinds kinds, Tool const& hand);

// As wide as a button with such a text has to be.
float button_width(std::string_view text);

} // namespace tractus
