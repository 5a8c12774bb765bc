#pragma once

#include "app/window/hand_input.h"

namespace tractus::window {

// For this frame ImGui's mouse is here, in the place of the window system's. Between the backend's
// beginning of a frame and ImGui's.
void put_imgui_mouse(ImVec2 const& place_px, bool is_down);

// For this frame the window system's mouse presses or lets go, where it did so: it may be elsewhere
// by now. At the same point of a frame.
void show_imgui_press(MouseMoment const& change);

} // namespace tractus::window
