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
    char const* text = ""; // Text on the button: the name of a group of tools.
    // Tool that the button selects: of the group's first kind, or of the first kind of the method
    // in the group that was used last.
    Tool tool;
};

// The top-level choices, one per group. `remembered` lists tools used before, the latest last. A
// choice has the options of the tool of its kind in this list, if there is one.
std::vector<ToolChoice> tool_choices(ToolKinds kinds, std::span<Tool const> remembered);

// A tool of this kind with its options in `remembered`, or else with default options.
Tool newly_selected_tool(ToolKind const& kind, std::span<Tool const> remembered);

// The tool to select when a drawing opens. If a tool made the active plant, this tool; if none did,
// as for a plant from a model, the first tool; without a plant, the first tool of a sketching
// method.
Tool tool_for_drawing(ToolKinds kinds, scene::Scene const& scene);

// True if both tools belong to the same group, such as the tools for drawing a branch and for
// redrawing a part of it.
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
    bool opens_cards = false;     // The button opens the kind's presets and selects no tool.
    bool is_beside_gizmo = false; // Shown only while the tool's gizmo is visible.
};

// Buttons for the variants of the current tool `hand`: one for each method of its group, if the
// group has methods, then those for all kinds of its method.
std::vector<Meaning> meanings_of(ToolKinds kinds, Tool const& hand,
                                 std::span<Tool const> remembered = {});

// Formats a number option with its label: "Angle 45°".
std::string describe_number(NumberSetting const& chosen);

// Formats a number with its unit: "45°", "30 mm", "2".
std::string with_unit(std::string_view number, NumberOption const& option);

// Width of a button with this text at a display scale of 1; a part after "##" is not counted.
float button_width(std::string_view text);

} // namespace tractus::tools
