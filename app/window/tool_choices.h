#pragma once

#include "app/tools/tool.h"

#include <array>
#include <vector>

namespace tractus {

// A tool as a button offers it.
struct ToolChoice {
    char const* text = "";
    Tool tool;
};

// Those among which a person chooses first; to erase means what it meant last.
std::array<ToolChoice, 4> tool_choices(Tool::Erasing erasing);

// Both belong to the same one of them: to draw a branch and to redraw a part of it is to draw.
bool is_same_tool(Tool const& one, Tool const& other);

// One of the things that the tool in hand may mean.
struct Meaning {
    char const* text = "";
    Tool tool;                 // To be chosen for it.
    float width = 0;           // Of its button, at a display's scale of 1.
    bool is_on = false;        // It means that now.
    bool begins_group = false; // Of meanings that exclude each other.
};
std::vector<Meaning> meanings_of(Tool const& hand);

} // namespace tractus
