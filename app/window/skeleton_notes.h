#pragma once

#include "app/view/window_model.h"
#include "app/window/pen_area.h"
#include "app/window/view_curves.h"

#include <imgui.h>

namespace tractus::window {

// Text and lines over the skeleton's view, drawn into the current ImGui window.

// Legend of the colours in the view; `corner_px` is its lower left corner.
void draw_skeleton_legend(SkeletonStates const& states, ImVec2 const& corner_px);

// Draws the pen's position and the stroke with which it is selecting.
void draw_selecting_ink(view::WindowState const& state, PenArea const& area);

} // namespace tractus::window
