#pragma once

#include "app/view/window_model.h"
#include "app/window/pen_area.h"

#include <imgui.h>
#include <string>

namespace tractus::window {

// Makes a sentence of a message: its first letter becomes a capital, unless a name begins there.
std::string as_sentence(std::string message);

// Draws the reason why the last stroke was refused, above or below the stroke, into the current
// ImGui window. Draws nothing if the stroke was accepted or was drawn in another view. `corner_px`
// and `size_px` are the view's; the text stays inside. `area` is where the view shows the tablet.
void draw_refusal(view::WindowState const& state, PenArea const& area, ImVec2 const& corner_px,
                  ImVec2 const& size_px);

} // namespace tractus::window
