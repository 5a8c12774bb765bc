#pragma once

#include "app/window/hand_input.h"

namespace tractus::window {

// Replaces the mouse that ImGui sees in this frame. Call this after NewFrame of ImGui's backend and
// before ImGui::NewFrame().
void put_imgui_mouse(ImVec2 const& place_px, bool is_down);

// Shows ImGui a press or release of the real mouse at the place where it happened, as the mouse may
// have moved on. Call this after NewFrame of ImGui's backend and before ImGui::NewFrame().
void show_imgui_press(MouseMoment const& change);

} // namespace tractus::window
