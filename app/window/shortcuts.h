#pragma once

#include "app/window/controls.h"
#include "app/window/hand_input.h"
#include "app/window/tool_ring.h"

namespace tractus::window {

// What the keyboard may be used for beside the pen.

// Does what a key asks for beside the views, and beside the calibration.
void take_shortcut(KeyPress const& press, view::WindowModel& model, Workbench& bench,
                   ToolRing& ring);
void take_calibration_shortcut(KeyPress const& press, view::WindowModel& model, Workbench& bench);

// Moves the surface by keys and, if `wheel_counts`, by the mouse's wheel, where no sensor measures
// its height.
void move_surface_as_wished(view::WindowModel& model, HandInput const& input, bool wheel_counts);

// Lists the keys in a panel over the views. Returns what it covers.
WindowPart show_shortcuts(tools::ToolKinds tools, ImGuiWindowFlags flags, float scale);

} // namespace tractus::window
