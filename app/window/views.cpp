#include "app/window/views.h"

#include "app/window/theme.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tractus::window {

namespace {

constexpr double kPadFieldOfView_rad = 0.75;
// Curves are shown up to this height above the surface, so that lines in the surface are not
// clipped to half their width.
constexpr double kAboveSurface_mm = 0.25;

render::Backdrop plain_backdrop()
{
    return { .top = theme::palette().pad_background,
             .bottom = theme::palette().pad_background,
             .ground = {},
             .has_ground = false };
}

// Returns a camera that looks straight down through the surface, at the scale of `area`.
render::Camera pad_camera(view::WindowState const& state, PenArea const& area,
                          render::Canvas const& canvas)
{
    auto const& box = state.volume_mm;
    double const height_mm = std::max(1.0, box.max_mm.z() - box.min_mm.z());
    double const distance_mm
        = canvas.height() / area.px_per_mm / 2 / std::tan(kPadFieldOfView_rad / 2);
    render::Camera camera;
    camera.target_mm << area.middle_mm, state.surface_height_mm;
    camera.eye_mm = camera.target_mm + Vec3(0, 0, distance_mm);
    camera.up = Vec3::UnitY();
    camera.field_of_view_rad = kPadFieldOfView_rad;
    camera.near_mm = distance_mm * 0.1;
    camera.far_mm = distance_mm + 4 * std::max(height_mm, area.size_mm.norm());
    return camera;
}

// Returns a camera that views the skeleton from a direction, at the scale of `area`.
render::Camera skeleton_camera(view::WindowState const& state, scene::SelectionAngle const& angle,
                               PenArea const& area, render::Canvas const& canvas)
{
    auto const view = scene::fit_selection_view(state.skeleton_box_mm, angle);
    double const radius_mm
        = std::max(1.0,
                   state.skeleton_box_mm.empty()
                       ? 1.0
                       : (state.skeleton_box_mm.max_mm - state.skeleton_box_mm.min_mm).norm());
    // Centre of the tablet in the plane of the view.
    Vec2 const middle_mm = -view.origin_mm / view.scale;
    render::Camera camera;
    camera.projection = render::Camera::Projection::Orthographic;
    camera.target_mm = middle_mm.x() * view.right + middle_mm.y() * view.up;
    camera.eye_mm = camera.target_mm + 4 * radius_mm * view.back;
    camera.up = view.up;
    camera.view_height_mm = canvas.height() / area.px_per_mm / view.scale;
    camera.near_mm = radius_mm * 0.1;
    camera.far_mm = 8 * radius_mm;
    return camera;
}

// Returns a picture placed on the surface.
render::StagedPicture staged(view::ShownPicture const& shown, render::GpuPicture const& picture,
                             double surface_mm)
{
    auto const& place = shown.place;
    double const turn_rad = place.turn_deg * std::numbers::pi / 180;
    Vec3 const right = place.width_mm * Vec3(std::cos(turn_rad), std::sin(turn_rad), 0);
    double const aspect = static_cast<double>(shown.image->height()) / shown.image->width();
    Vec3 const down = aspect * Vec3(right.y(), -right.x(), 0);
    Vec3 const middle_mm(place.x_mm, place.y_mm, surface_mm);
    return { .picture = &picture,
             .corner_mm = (middle_mm - (right + down) / 2).cast<float>(),
             .right_mm = right.cast<float>(),
             .down_mm = down.cast<float>(),
             .strength = static_cast<float>(place.strength) };
}

// Extends the plant's box by the middle of the sheet of paper in the drawing volume, and by the
// previewed branches, so that the view need not change while the plant grows.
void add_drawing_room(view::WindowState const& state, Bounds& plant_mm)
{
    auto const& box_mm = state.volume_mm;
    if (!box_mm.empty()) {
        auto const T_plant_world = state.T_world_plant.inverse();
        Vec3 const size_mm = box_mm.max_mm - box_mm.min_mm;
        Vec3 const foot_mm = (box_mm.min_mm + box_mm.max_mm - size_mm.z() * Vec3::UnitZ()) / 2;
        Vec3 const aside_mm = size_mm.x() / 4 * Vec3::UnitX();
        Vec3 const top_mm = foot_mm + size_mm.y() * Vec3::UnitZ();
        for (Vec3 const& corner_mm : { Vec3(foot_mm - aside_mm), Vec3(top_mm + aside_mm) })
            plant_mm.add((T_plant_world * corner_mm.cast<float>()).cast<double>());
    }
    for (auto const& line : state.preview)
        for (auto const& point_mm : line.points_mm)
            plant_mm.add(point_mm.cast<double>());
}

double aspect_of(render::Canvas const& canvas)
{
    return static_cast<double>(canvas.width()) / canvas.height();
}

} // namespace

render::Canvas& ViewCanvas::sized(ImVec2 const& size_px, bool& changed)
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
    // Flips the texture vertically, as OpenGL's rows go upwards and ImGui's downwards.
    auto* const texture = reinterpret_cast<void*>(static_cast<std::uintptr_t>(canvas_->texture()));
    ImVec2 const size(static_cast<float>(canvas_->width()), static_cast<float>(canvas_->height()));
    ImGui::Image(texture, size, ImVec2(0, 1), ImVec2(1, 0));
}

void PadView::show(view::WindowState const& state, render::Renderer& renderer, PenArea const& area,
                   ImVec2 const& size_px)
{
    bool changed = std::exchange(px_per_mm_, area.px_per_mm) != area.px_per_mm;
    // The sheet of paper moves with the surface, and the drawing on it moves, too.
    auto const T_pad_world = pad_of_world(state);
    turns_ += T_pad_world.matrix() != T_pad_world_.matrix();
    T_pad_world_ = T_pad_world;
    changed |= skeleton_.follow(state.skeleton_revision + turns_,
                                [&] { return pad_skeleton_curves(state); });
    changed |= preview_.follow(state.preview_revision + turns_,
                               [&] { return pad_preview_curves(state); });
    changed |= strokes_.follow(state.strokes_revision + turns_,
                               [&] { return pad_stroke_curves(state); });
    changed |= live_.follow(state.live_revision, [&] { return pad_live_curves(state); });
    changed |= std::exchange(picture_revision_, state.picture_revision) != state.picture_revision;
    auto const image = state.picture ? state.picture->image : nullptr;
    if (std::exchange(shown_picture_, image) != image) {
        picture_.reset();
        if (image)
            picture_.emplace(*image);
    }
    auto const& canvas = canvas_.sized(size_px, changed);
    if (changed) {
        render::Stage stage;
        stage.curves = { skeleton_.curves(), preview_.curves(), strokes_.curves(), live_.curves() };
        stage.backdrop = plain_backdrop();
        if (picture_)
            stage.picture = staged(*state.picture, *picture_, state.surface_height_mm);
        if (!draws_on_paper(state))
            stage.hidden_above_mm = state.surface_height_mm + kAboveSurface_mm;
        stage.fade = pad_fade(state);
        renderer.draw(stage, pad_camera(state, area, canvas), canvas);
    }
    canvas_.show();
}

void zoom(scene::SelectionAngle& angle, double factor)
{
    angle.zoom = std::clamp(angle.zoom * factor, 0.4, 40.0);
}

void turn_skeleton(scene::SelectionAngle& angle, PenArea const& area, bool left_turns,
                   ViewDrag drag)
{
    auto const& io = ImGui::GetIO();
    if (ImGui::IsItemHovered() && io.MouseWheel != 0)
        zoom(angle, std::pow(kZoomStep, static_cast<double>(io.MouseWheel)));
    bool const turns = ImGui::IsMouseDragging(ImGuiMouseButton_Right, 0)
        || (left_turns && ImGui::IsItemActive());
    if (!turns || (!ImGui::IsItemHovered() && !ImGui::IsItemActive()))
        return;
    Vec2 const by_mm = Vec2(io.MouseDelta.x, -io.MouseDelta.y) / area.px_per_mm;
    if (io.KeyShift || drag == ViewDrag::Move) {
        angle.moved_mm += by_mm;
        return;
    }
    constexpr double kPerMm_deg = 1.2;
    angle.azimuth_deg = std::remainder(angle.azimuth_deg - kPerMm_deg * by_mm.x(), 360);
    angle.elevation_deg = std::clamp(angle.elevation_deg - kPerMm_deg * by_mm.y(), -10.0, 85.0);
}

void SkeletonView::show(view::WindowState const& state, render::Renderer& renderer,
                        scene::SelectionAngle const& angle, PenArea const& area,
                        ImVec2 const& size_px)
{
    bool changed = curves_.follow(state.skeleton_revision, [&] {
        states_ = skeleton_states(state);
        return skeleton_curves(state);
    });
    changed |= preview_.follow(state.preview_revision, [&] { return preview_curves(state); });
    changed |= std::exchange(angle_, angle) != angle;
    changed |= std::exchange(px_per_mm_, area.px_per_mm) != area.px_per_mm;
    auto const& canvas = canvas_.sized(size_px, changed);
    if (changed) {
        render::Stage stage;
        stage.curves = { curves_.curves(), preview_.curves() };
        stage.backdrop = plain_backdrop();
        renderer.draw(stage, skeleton_camera(state, angle, area, canvas), canvas);
    }
    canvas_.show();
}

// Frames a plant that is just being drawn.
void PlantView::follow_first_plant(double scale)
{
    if (!std::exchange(is_first_, true))
        first_frame_ = view::SteadyFrame(1 / scale);
    if (auto const box_mm = mesh_->bounds(); !box_mm.empty()) {
        Vec3 foot_mm = (box_mm.min_mm + box_mm.max_mm) / 2;
        foot_mm.z() = box_mm.min_mm.z();
        for (auto const& point_mm : { foot_mm, box_mm.min_mm, box_mm.max_mm })
            first_frame_.add(point_mm);
    }
    framed_mm_ = first_frame_.box_mm();
}

// Uploads the state's plant if it is new. Returns true if the plant or the view of it has changed.
bool PlantView::follow_plant(view::WindowState const& state)
{
    bool changed = std::exchange(turned_, false);
    changed |= std::exchange(is_light_, theme::palette().is_light) != theme::palette().is_light;
    if (state.plant == nullptr || (mesh_ && state.plant_revision == revision_))
        return changed;
    mesh_.emplace(*state.plant);
    underground_.emplace(underground_curves(state));
    revision_ = state.plant_revision;
    if (state.growth.age >= 1 || is_first_)
        framed_mm_ = {};
    if (state.is_first_plant_drawn) {
        follow_first_plant(state.first_plant_scale);
        return true;
    }
    is_first_ = false;
    if (auto const box_mm = mesh_->bounds(); !box_mm.empty()) {
        framed_mm_.add(box_mm.min_mm);
        framed_mm_.add(box_mm.max_mm);
    }
    return true;
}

void PlantView::draw(render::Renderer& renderer, Bounds const& framed_mm,
                     render::Canvas const& canvas, render::GpuCurves const* curves)
{
    render::Stage stage;
    stage.backdrop = is_light_ ? render::Backdrop() : render::dark_backdrop();
    if (mesh_ && !(is_first_ && was_on_stage_))
        stage.meshes.push_back({ &*mesh_ });
    if (underground_)
        stage.curves.push_back(&*underground_);
    if (curves)
        stage.curves.push_back(curves);
    renderer.draw(stage, orbit_.camera(framed_mm, aspect_of(canvas)), canvas);
}

void PlantView::show(view::WindowState const& state, render::Renderer& renderer,
                     ImVec2 const& size_px, ViewDrag drag)
{
    bool changed = follow_plant(state);
    changed |= std::exchange(was_on_stage_, false);
    changed |= growing_.follow(state.preview_revision, [&] { return growing_curves(state); });
    auto const& canvas = canvas_.sized(size_px, changed);
    // A first plant fills no box yet.
    auto const& box_mm = framed_mm_.empty() ? state.skeleton_box_mm : framed_mm_;
    if (changed) // The first plant contains the branches that the stroke makes.
        draw(renderer, box_mm, canvas, is_first_ ? nullptr : growing_.curves());
    canvas_.show();
    turned_ = orbit_.take_input(ImGui::GetFontSize() / theme::kTextSize_px, size_px.y, drag);
}

void PlantView::show_on_stage(view::WindowState const& state, render::Renderer& renderer,
                              ImVec2 const& size_px, ViewDrag drag, bool may_turn)
{
    bool changed = follow_plant(state);
    if (!std::exchange(was_on_stage_, true)) {
        framed_on_stage_mm_ = {};
        changed = true;
    }
    if (!state.preview.empty())
        grows_on_ = state.plant_revision;
    // Curves that have grown stay visible until they are part of the plant, or the stroke is
    // refused.
    bool const waits = state.preview.empty() && grows_on_ == state.plant_revision && !state.refused;
    if (!waits)
        changed |= growing_.follow(state.preview_revision, [&] { return growing_curves(state); });
    auto const& canvas = canvas_.sized(size_px, changed);
    if (changed) {
        if (!framed_mm_.empty() && !is_first_) {
            framed_on_stage_mm_.add(framed_mm_.min_mm);
            framed_on_stage_mm_.add(framed_mm_.max_mm);
        }
        add_drawing_room(state, framed_on_stage_mm_);
        draw(renderer, framed_on_stage_mm_, canvas, growing_.curves());
    }
    canvas_.show();
    if (may_turn)
        turned_ = orbit_.take_input(ImGui::GetFontSize() / theme::kTextSize_px, size_px.y, drag);
}

void PlantView::zoom(double factor)
{
    orbit_.zoom(factor);
    turned_ = true;
}

void PlantView::look_at_whole()
{
    orbit_.look_at_whole();
    turned_ = true;
}

render::Image PlantView::picture(render::Renderer& renderer, int width, int height) const
{
    if (!mesh_)
        return {};
    render::Stage stage;
    stage.meshes.push_back({ &*mesh_ });
    return renderer.picture(stage, orbit_.camera(framed_mm_, static_cast<double>(width) / height),
                            width, height);
}

} // namespace tractus::window
