#pragma once

#include <imgui.h>

// What ImGui's versions of Debian 12 and 13 call differently.
namespace tractus::input {

// For this frame the mouse is here, in the place of the window system's. Between the backend's
// beginning of a frame and ImGui's.
void put_mouse(ImVec2 const& place_px, bool is_down);

// `letter` is a capital.
bool is_pressed(char letter);
bool is_held(char letter);
bool is_question_mark_typed();
bool is_escape_pressed();

} // namespace tractus::input
