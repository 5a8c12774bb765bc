#pragma once

#include "app/tools/gizmo.h"

#include <imgui.h>

namespace tractus::window {

// Position of a gizmo's square in the window, in pixels.
struct GizmoSquare {
    ImVec2 middle { 0, 0 };
    float half = 1;

    ImVec2 to_px(Vec2 const& place) const;
    Vec2 to_frame(ImVec2 const& place_px) const;
};

// Draws the lines of a gizmo into the current ImGui window. `scale` is the display's scale factor.
void draw_gizmo(tools::Gizmo const& gizmo, GizmoSquare const& square, float scale);

} // namespace tractus::window
