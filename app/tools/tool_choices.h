#pragma once

#include "app/tools/tool.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::tools {

// A button of the tool bar and of the tool ring.
struct ToolChoice {
    char const* text = ""; // Name of the group that the button selects.
    Tool tool;             // First kind of the group, or of its method used last.
};

// The top-level choices, one per group. `remembered` lists tools used before, the latest last; a
// choice of such a kind has its old options.
std::vector<ToolChoice> tool_choices(ToolKinds kinds, std::span<Tool const> remembered);

// A tool of this kind with the options that a new selection gives it.
Tool newly_selected_tool(ToolKind const& kind, std::span<Tool const> remembered);

// The tool to select when a drawing opens: the one that made the active plant; for a plant that no
// tool made, such as a model's, the first tool; without a plant, the first tool that makes one.
Tool tool_for_drawing(ToolKinds kinds, scene::Scene const& scene);

// True if both tools belong to the same group; drawing a branch and redrawing a part of it do, for
// example.
bool is_same_group(Tool const& one, Tool const& other);

// One of the buttons for the current tool's variants.
struct Meaning {
    std::string text {};       // The part after "##" is not shown; it identifies the button.
    Tool tool;                 // Tool that the button selects.
    float width = 0;           // Width of the button at a display scale of 1.
    bool is_on = false;        // True if this variant is selected.
    bool begins_group = false; // Starts a group of mutually exclusive buttons.
    // If set, the button asks for the tool's number option with this index and selects no tool.
    std::optional<std::size_t> number {};
    bool opens_cards = false;     // The button opens the tool's presets and selects no tool.
    bool is_beside_gizmo = false; // Offered only while the gizmo is visible.
};

// Buttons for the variants of the tool's group and method, preceded by the group's other methods.
std::vector<Meaning> meanings_of(ToolKinds kinds, Tool const& hand,
                                 std::span<Tool const> remembered = {});

// Formats a number option with its label: "Angle 45°".
std::string describe_number(NumberSetting const& chosen);

// Formats a number with its unit: "45°", "30 mm", "2".
std::string with_unit(std::string_view number, NumberOption const& option);

// Width that a button needs for this text.
float button_width(std::string_view text);

} // namespace tractus::tools
