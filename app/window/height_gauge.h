#pragma once

#include "app/station/window_model.h"

#include <imgui.h>

namespace tractus {

// A ruler of the surface's calibrated range with a mark at its present height. Draws over the
// current ImGui window; `corner` is the upper left one.
void draw_height_gauge(WindowState const& state, ImVec2 const& corner, ImVec2 const& size);

} // namespace tractus
