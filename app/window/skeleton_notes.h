#pragma once

#include "app/view/window_model.h"
#include "app/window/pen_area.h"
#include "app/window/view_curves.h"

#include <imgui.h>

namespace tractus::window {

// What is written and drawn over the skeleton's view, into the current ImGui window.

// What the colours mean that are in it; `corner_px` is the lower left one.
void draw_skeleton_legend(SkeletonStates const& states, ImVec2 const& corner_px);

// What a pen that selects has drawn, and where it is.
void draw_selecting_ink(view::WindowState const& state, PenArea const& area);

} // namespace tractus::window
