#pragma once

#include "app/view/window_model.h"
#include "app/window/pen_area.h"
#include "app/window/view_curves.h"

#include <imgui.h>

namespace tractus::window {

// Texts and lines over the skeleton's view, drawn into the current ImGui window.

// Draws the legend of the colours in the view. `corner_px` is the legend's lower left corner.
void draw_skeleton_legend(SkeletonStates const& states, ImVec2 const& corner_px);

// Draws the pen's position, and the stroke with which the pen is selecting branches.
void draw_selecting_ink(view::WindowState const& state, PenArea const& area);

} // namespace tractus::window
