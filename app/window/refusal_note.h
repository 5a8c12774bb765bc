#pragma once

#include "app/view/window_model.h"
#include "app/window/pen_area.h"

#include <imgui.h>
#include <string>

namespace tractus::window {

// What a message of the program says, as a sentence of its own: with a capital, unless it begins
// with the name of something.
std::string as_sentence(std::string message);

// Why the last stroke was refused, below or above it, into the current ImGui window; nothing if it
// was not, or was drawn on something else. `corner_px` and `size_px` are the view's, in which the
// words stay; `area` is where it shows the tablet.
void draw_refusal(view::WindowState const& state, PenArea const& area, ImVec2 const& corner_px,
                  ImVec2 const& size_px);

} // namespace tractus::window
