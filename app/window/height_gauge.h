#pragma once

#include "app/view/window_model.h"

#include <imgui.h>

namespace tractus::window {

enum class Side { Left, Right };

// Draws a ruler of the surface's calibrated range with a mark at its current height over the
// current ImGui window. `corner` is the ruler's upper left corner, `side` the edge of the view that
// it lies along.
void draw_height_gauge(view::WindowState const& state, ImVec2 const& corner, ImVec2 const& size,
                       Side side);

} // namespace tractus::window
