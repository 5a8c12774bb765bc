#pragma once

#include "app/window/controls.h"
#include "app/window/hand_input.h"
#include "app/window/tool_ring.h"

namespace tractus::window {

// Keyboard shortcuts of the window and of its pages.

// Handle a key: take_shortcut() while the drawing is shown, take_calibration_shortcut() while the
// calibration page is shown.
void take_shortcut(KeyPress const& press, view::WindowModel& model, Workspace& workspace,
                   ToolRing& ring);
void take_calibration_shortcut(KeyPress const& press, view::WindowModel& model,
                               Workspace& workspace);

// Moves the surface by keys and, with `wheel_counts`, by the mouse wheel. Does nothing if a sensor
// measures the surface's height.
void apply_surface_request(view::WindowModel& model, HandInput const& input, bool wheel_counts);

// Shows a list of the keyboard shortcuts in a panel over the views. Returns the panel's rectangle.
WindowPart show_shortcuts(tools::ToolKinds tools, ImGuiWindowFlags flags, float scale);

} // namespace tractus::window
