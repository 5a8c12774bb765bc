#include "app/window/orbit.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace tractus::window {

bool Orbit::take_input(float scale, float height_px, ViewDrag drag)
{
    if (!ImGui::IsItemHovered())
        return false;
    auto const& io = ImGui::GetIO();
    bool changed = false;
    if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0)
        && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
        Vec2 const by_px(io.MouseDelta.x, -io.MouseDelta.y);
        constexpr double kPerPixel_rad = 0.008;
        if (io.KeyShift || drag == ViewDrag::Move) {
            moved_ += by_px / static_cast<double>(height_px) / zoom_;
        } else {
            angles_.azimuth_rad -= kPerPixel_rad * by_px.x() / static_cast<double>(scale);
            angles_.elevation_rad = std::clamp(
                angles_.elevation_rad - kPerPixel_rad * by_px.y() / static_cast<double>(scale),
                0.02, 1.45);
        }
        changed = true;
    }
    if (io.MouseWheel != 0) {
        zoom(std::pow(kZoomStep, static_cast<double>(io.MouseWheel)));
        changed = true;
    }
    return changed;
}

void Orbit::zoom(double factor)
{
    zoom_ = std::clamp(zoom_ * factor, 0.4, 20.0);
}

void Orbit::look_at_whole()
{
    zoom_ = 1;
    moved_.setZero();
}

render::Camera Orbit::camera(Bounds const& box, double aspect) const
{
    auto camera = render::framing_camera(box, angles_, aspect);
    Vec3 const to_target_mm = camera.target_mm - camera.eye_mm;
    double const height_mm
        // Height of the visible area at the distance of the target.
        = 2 * to_target_mm.norm() * std::tan(camera.field_of_view_rad / 2);
    Vec3 const right = to_target_mm.cross(camera.up).normalized();
    Vec3 const up = right.cross(to_target_mm).normalized();
    camera.target_mm -= height_mm * (moved_.x() * right + moved_.y() * up);
    camera.eye_mm = camera.target_mm - to_target_mm / zoom_;
    camera.near_mm /= 4 * zoom_;
    return camera;
}

} // namespace tractus::window
