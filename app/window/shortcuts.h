#pragma once

#include "app/window/controls.h"
#include "app/window/hand_input.h"
#include "app/window/tool_ring.h"

namespace tractus::window {

// Keyboard shortcuts of the window.

// Handles a shortcut on the drawing page; the calibration page has no shortcuts.
void take_shortcut(KeyPress const& press, view::WindowModel& model, Workspace& workspace,
                   ToolRing& ring);
void take_calibration_shortcut(KeyPress const& press, view::WindowModel& model,
                               Workspace& workspace);

// Moves the surface by keys and, if `wheel_counts`, by the mouse wheel, when no sensor measures its
// height.
void apply_surface_request(view::WindowModel& model, HandInput const& input, bool wheel_counts);

// Shows a list of the keys in a panel over the views. Returns its rectangle.
WindowPart show_shortcuts(tools::ToolKinds tools, ImGuiWindowFlags flags, float scale);

} // namespace tractus::window
