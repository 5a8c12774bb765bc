#pragma once

#include "app/window/hand_input.h"

namespace tractus::window {

// Overrides the mouse that ImGui sees in this frame. Call between the backend's NewFrame and
// ImGui's.
void put_imgui_mouse(ImVec2 const& place_px, bool is_down);

// Makes ImGui see a press or release of the real mouse at the place where it happened, since the
// mouse may have moved on. Call at the same point of a frame.
void show_imgui_press(MouseMoment const& change);

} // namespace tractus::window
