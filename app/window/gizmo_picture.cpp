#include "app/window/gizmo_picture.h"

#include "app/window/theme.h"
#include "app/window/view_curves.h"

#include <algorithm>
#include <vector>

namespace tractus::window {

ImVec2 GizmoSquare::to_px(Vec2 const& place) const
{
    return { middle.x + half * static_cast<float>(place.x()),
             middle.y - half * static_cast<float>(place.y()) };
}

Vec2 GizmoSquare::to_frame(ImVec2 const& place_px) const
{
    return { static_cast<double>((place_px.x - middle.x) / half),
             static_cast<double>((middle.y - place_px.y) / half) };
}

void draw_gizmo(tools::Gizmo const& gizmo, GizmoSquare const& square, float scale)
{
    constexpr float kThinnest_px = 1.5f;
    auto* const draw = ImGui::GetWindowDrawList();
    std::vector<ImVec2> points;
    for (auto const& line : gizmo.lines) {
        points.clear();
        for (auto const& point : line.points)
            points.push_back(square.to_px(point));
        draw->AddPolyline(
            points.data(), static_cast<int>(points.size()),
            theme::packed(layer_color({ .color = line.color })), 0,
            std::max(kThinnest_px * scale, square.half * static_cast<float>(line.width)));
    }
}

} // namespace tractus::window
