#pragma once

#include "app/view/window_model.h"
#include "app/window/pen_area.h"

#include <imgui.h>
#include <string>

namespace tractus::window {

// Turns a message into a sentence with a capital letter, unless it begins with a name.
std::string as_sentence(std::string message);

// Draws the reason why the last stroke was refused below or above it into the current ImGui window;
// nothing if it was accepted, or was drawn in another view. `corner_px` and `size_px` are the
// view's, within which the text stays; `area` is where the view shows the tablet.
void draw_refusal(view::WindowState const& state, PenArea const& area, ImVec2 const& corner_px,
                  ImVec2 const& size_px);

} // namespace tractus::window
