#include "app/window/views.h"

#include "app/window/theme.h"
#include "app/window/view_curves.h"

#include <algorithm>
#include <cmath>

namespace tractus {

namespace {

constexpr double kPadFieldOfView_rad = 0.75;
constexpr double kAboveSurface_mm = 0.25; // Ink lies on the surface; half its width would vanish.

Backdrop plain_backdrop()
{
    return { .top = theme::kPadBackground,
             .bottom = theme::kPadBackground,
             .ground = {},
             .has_ground = false };
}

// Straight down through the surface, whose rectangle just fits into the picture.
Camera pad_camera(WindowState const& state, double aspect)
{
    auto const& box = state.volume_mm;
    Vec3 const size = box.max_mm - box.min_mm;
    double const half_mm = std::max({ size.y() / 2, size.x() / 2 / aspect, 1.0 }) * 1.06;
    double const distance_mm = half_mm / std::tan(kPadFieldOfView_rad / 2);
    Camera camera;
    camera.target_mm = (box.min_mm + box.max_mm) / 2;
    camera.target_mm.z() = state.surface_height_mm;
    camera.eye_mm = camera.target_mm + Vec3(0, 0, distance_mm);
    camera.up = Vec3::UnitY();
    camera.field_of_view_rad = kPadFieldOfView_rad;
    camera.near_mm = distance_mm * 0.1;
    camera.far_mm = distance_mm + 4 * std::max(size.z(), size.norm());
    return camera;
}

double aspect_of(Canvas const& canvas)
{
    return static_cast<double>(canvas.width()) / canvas.height();
}

} // namespace

Canvas& ViewCanvas::sized(ImVec2 const& size_px, bool& changed)
{
    int const width = std::max(1, static_cast<int>(size_px.x));
    int const height = std::max(1, static_cast<int>(size_px.y));
    if (!canvas_ || canvas_->width() != width || canvas_->height() != height) {
        canvas_.emplace(width, height);
        changed = true;
    }
    return *canvas_;
}

void ViewCanvas::show() const
{
    // OpenGL's rows go up, ImGui's down.
    auto* const texture = reinterpret_cast<void*>(static_cast<std::uintptr_t>(canvas_->texture()));
    ImVec2 const size(static_cast<float>(canvas_->width()), static_cast<float>(canvas_->height()));
    ImGui::Image(texture, size, ImVec2(0, 1), ImVec2(1, 0));
}

void PadView::show(WindowState const& state, Renderer& renderer, ImVec2 const& size_px)
{
    bool changed = false;
    changed
        |= skeleton_.follow(state.skeleton_revision, [&] { return pad_skeleton_curves(state); });
    changed |= preview_.follow(state.preview_revision, [&] { return pad_preview_curves(state); });
    changed |= strokes_.follow(state.strokes_revision, [&] { return pad_stroke_curves(state); });
    changed |= live_.follow(state.live_revision, [&] { return pad_live_curves(state); });
    auto const& canvas = canvas_.sized(size_px, changed);
    if (changed) {
        Stage stage;
        stage.curves = { skeleton_.curves(), preview_.curves(), strokes_.curves(), live_.curves() };
        stage.backdrop = plain_backdrop();
        stage.hidden_above_mm = state.surface_height_mm + kAboveSurface_mm;
        stage.fade = pad_fade(state);
        renderer.draw(stage, pad_camera(state, aspect_of(canvas)), canvas);
    }
    canvas_.show();
}

bool Orbit::take_input(float scale)
{
    if (!ImGui::IsItemHovered())
        return false;
    auto const& io = ImGui::GetIO();
    bool changed = false;
    if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0)
        && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
        constexpr double kPerPixel_rad = 0.008;
        angles_.azimuth_rad -= kPerPixel_rad * static_cast<double>(io.MouseDelta.x / scale);
        angles_.elevation_rad = std::clamp(
            angles_.elevation_rad + kPerPixel_rad * static_cast<double>(io.MouseDelta.y / scale),
            0.02, 1.45);
        changed = true;
    }
    if (io.MouseWheel != 0) {
        zoom_ = std::clamp(zoom_ * std::pow(1.12, static_cast<double>(io.MouseWheel)), 0.4, 8.0);
        changed = true;
    }
    return changed;
}

Camera Orbit::camera(Bounds const& box, double aspect) const
{
    auto camera = framing_camera(box, angles_, aspect);
    camera.eye_mm = camera.target_mm + (camera.eye_mm - camera.target_mm) / zoom_;
    camera.near_mm /= 4 * zoom_;
    return camera;
}

void SkeletonView::show(WindowState const& state, Renderer& renderer, ImVec2 const& size_px)
{
    bool changed = turned_;
    changed |= preview_.follow(state.preview_revision, [&] { return preview_curves(state); });
    if (curves_.follow(state.skeleton_revision, [&] { return skeleton_curves(state); })) {
        changed = true;
        box_ = Bounds();
        for (auto const& line : state.skeleton)
            for (auto const& point : line.points_mm)
                box_.add(point.cast<double>());
        for (auto const& arrow : state.indicators) {
            box_.add(arrow.from_mm.cast<double>());
            box_.add(arrow.to_mm.cast<double>());
        }
    }
    auto const& canvas = canvas_.sized(size_px, changed);
    if (changed) {
        Stage stage;
        stage.curves = { curves_.curves(), preview_.curves() };
        stage.backdrop = plain_backdrop();
        renderer.draw(stage, orbit_.camera(box_, aspect_of(canvas)), canvas);
    }
    canvas_.show();
    turned_ = orbit_.take_input(ImGui::GetFontSize() / theme::kTextSize_px);
}

void PlantView::show(WindowState const& state, Renderer& renderer, ImVec2 const& size_px)
{
    bool changed = turned_;
    if (state.plant != nullptr && (!mesh_ || state.plant_revision != revision_)) {
        mesh_.emplace(*state.plant);
        revision_ = state.plant_revision;
        changed = true;
    }
    auto const& canvas = canvas_.sized(size_px, changed);
    if (changed) {
        Stage stage;
        stage.backdrop = dark_backdrop();
        if (mesh_)
            stage.meshes.push_back({ &*mesh_ });
        renderer.draw(stage, orbit_.camera(bounds(stage), aspect_of(canvas)), canvas);
    }
    canvas_.show();
    turned_ = orbit_.take_input(ImGui::GetFontSize() / theme::kTextSize_px);
}

Image PlantView::picture(Renderer& renderer, int width, int height) const
{
    if (!mesh_)
        return {};
    Stage stage;
    stage.meshes.push_back({ &*mesh_ });
    return renderer.picture(
        stage, orbit_.camera(mesh_->bounds(), static_cast<double>(width) / height), width, height);
}

} // namespace tractus
