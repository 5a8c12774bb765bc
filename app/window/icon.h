#pragma once

#include <imgui.h>

namespace tractus::window {

// Draws an icon into the current ImGui window. The icon consists of lines in the notation of
// ToolKind::icon. It fills a square with sides of `size`, of which `foot` is the middle of the
// lower edge.
void draw_icon(char const* icon, ImVec2 const& foot, float size, float line_width);

} // namespace tractus::window
