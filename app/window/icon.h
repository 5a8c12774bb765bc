#pragma once

#include <imgui.h>

namespace tractus::window {

// Draws lines as ToolKind::icon has them into the current window, `size` large above the middle of
// its lower edge, and so wide.
void draw_icon(char const* icon, ImVec2 const& foot, float size, float line_width);

} // namespace tractus::window
