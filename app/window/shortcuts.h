#pragma once

#include "app/window/controls.h"
#include "app/window/tool_ring.h"

namespace tractus {

// What the keyboard may be used for beside the pen, in the window with the views.

// Does what the keys of this frame ask for.
void take_shortcuts(WindowModel& model, Workbench& bench, ToolRing& ring);

// Moves the surface by keys and, if `wheel_counts`, by the mouse's wheel, where no sensor measures
// its height.
void move_surface_as_wished(WindowModel& model, bool wheel_counts);

// Lists the keys in a panel over the views. Returns what it covers.
WindowPart show_shortcuts(ImGuiWindowFlags flags, float scale);

} // namespace tractus
