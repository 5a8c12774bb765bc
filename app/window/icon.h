#pragma once

#include <imgui.h>

namespace tractus::window {

// Draws an icon (lines in the notation of ToolKind::icon) into the current ImGui window, in a
// square of side `size` with the middle of its lower edge at `foot`.
void draw_icon(char const* icon, ImVec2 const& foot, float size, float line_width);

} // namespace tractus::window
