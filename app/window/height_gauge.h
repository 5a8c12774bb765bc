#pragma once

#include "app/view/window_model.h"

#include <imgui.h>

namespace tractus::window {

enum class Side { Left, Right };

// Draws a ruler of the surface's calibrated range over the current ImGui window, with a mark at the
// surface's current height. `corner` is the ruler's upper left corner; `side` is the edge of the
// view along which the ruler is drawn.
void draw_height_gauge(view::WindowState const& state, ImVec2 const& corner, ImVec2 const& size,
                       Side side);

} // namespace tractus::window
