#include "app/window/stroke_scene.h"

#include "app/window/palette.h"
#include "app/window/view_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tractus::window {

namespace {

// Minimum width of a curve, as a share of the diagonal of strokes_box().
constexpr float kThinnest = 1.0f / 220;
constexpr float kWider = 1.9f; // Factor by which highlighted curves are wider.
// Diameter of the dot at a curve's beginning, as a multiple of the curve's width.
constexpr float kDotSize = 1.9f;
constexpr std::size_t kMaxDropLines = 3;

render::Curve thin_line(Vec3f const& from_mm, Vec3f const& to_mm, Vec3f const& color,
                        float width_px)
{
    render::Curve curve;
    curve.look = render::Curve::Look::Flat;
    curve.points = { { from_mm, color, width_px }, { to_mm, color, width_px } };
    return curve;
}

float diagonal_mm(Bounds const& box)
{
    return static_cast<float>((box.max_mm - box.min_mm).norm());
}

// Returns the bounding box of all curves, the plant's base and the ground. Without curves, returns
// the drawing volume.
Bounds curves_box(view::WindowState const& state)
{
    Bounds box;
    for (auto const& curve : state.curves)
        for (auto const& point : curve.line.points)
            box.add(point.position_mm.cast<double>());
    if (box.empty()) {
        box = state.volume_mm;
        if (box.empty())
            box.add(Vec3(0, 0, 0));
    } else {
        box.add(state.T_world_plant.translation().cast<double>());
        if (!state.volume_mm.empty())
            box.min_mm.z() = std::min(box.min_mm.z(), state.volume_mm.min_mm.z());
    }
    // Minimum extent of the box: the camera cannot show an empty one.
    constexpr double kMin_mm = 10;
    box.max_mm = box.max_mm.cwiseMax(box.min_mm + Vec3::Constant(kMin_mm));
    return box;
}

// A grid on the ground around the curves and the plant's base. Its edges are at multiples of the
// grid's step.
struct GroundGrid {
    Vec2f low_mm;
    Vec2f high_mm;
    float height_mm;
    float step_mm;
};

GroundGrid ground_grid(view::WindowState const& state)
{
    // Minimum width of the grid, as a share of the curves' height.
    constexpr float kMinWidth = 0.6f;
    auto const box = curves_box(state);
    Vec3f const low_mm = box.min_mm.cast<float>();
    Vec3f const high_mm = box.max_mm.cast<float>();
    float const step_mm = grid_step_mm((high_mm - low_mm).maxCoeff());
    Vec2f const middle_mm = (low_mm + high_mm).head<2>() / 2;
    float const min_mm = kMinWidth * (high_mm - low_mm).z() / 2;
    Vec2f const half_mm = ((high_mm - low_mm).head<2>() / 2).cwiseMax(min_mm);
    return { .low_mm = ((middle_mm - half_mm) / step_mm).array().floor() * step_mm,
             .high_mm = ((middle_mm + half_mm) / step_mm).array().ceil() * step_mm,
             .height_mm = low_mm.z(),
             .step_mm = step_mm };
}

void add_grid(GroundGrid const& grid, std::vector<render::Curve>& curves)
{
    auto const& color = theme::palette().grid;
    auto const lines = [&](int axis) {
        return static_cast<int>(
            std::lround((grid.high_mm[axis] - grid.low_mm[axis]) / grid.step_mm));
    };
    auto const place = [&](int axis, int line) {
        return grid.low_mm[axis] + static_cast<float>(line) * grid.step_mm;
    };
    for (int i = 0; i <= lines(0); ++i)
        curves.push_back(thin_line({ place(0, i), grid.low_mm.y(), grid.height_mm },
                                   { place(0, i), grid.high_mm.y(), grid.height_mm }, color, 1));
    for (int i = 0; i <= lines(1); ++i)
        curves.push_back(thin_line({ grid.low_mm.x(), place(1, i), grid.height_mm },
                                   { grid.high_mm.x(), place(1, i), grid.height_mm }, color, 1));
}

void add_upright(view::WindowState const& state, GroundGrid const& grid,
                 std::vector<render::Curve>& curves)
{
    auto const& color = theme::palette().unselected;
    Vec3f foot_mm = state.T_world_plant.translation();
    foot_mm.z() = grid.height_mm;
    auto const top_mm = static_cast<float>(strokes_box(state).max_mm.z());
    curves.push_back(thin_line(foot_mm, { foot_mm.x(), foot_mm.y(), top_mm }, color, 1.5f));
    Vec3f const arm_mm(grid.step_mm / 8, 0, 0);
    for (float z = grid.height_mm + grid.step_mm; z <= top_mm; z += grid.step_mm) {
        Vec3f const at_mm(foot_mm.x(), foot_mm.y(), z);
        curves.push_back(thin_line(at_mm - arm_mm, at_mm + arm_mm, color, 1.5f));
    }
}

float squared_distance_to_segment(Vec2f const& place, Vec2f const& from, Vec2f const& to)
{
    Vec2f const way = to - from;
    float const length2 = std::max(way.squaredNorm(), 1e-12f);
    float const share = std::clamp((place - from).dot(way) / length2, 0.0f, 1.0f);
    return (from + share * way - place).squaredNorm();
}

} // namespace

std::vector<std::size_t> highlighted_curves(view::WindowState const& state,
                                            std::optional<std::size_t> picked)
{
    auto const count = state.curves.size();
    if (picked && *picked < count)
        return { *picked };
    std::vector<std::size_t> highlighted;
    for (std::size_t i = 0; i < count; ++i)
        if (state.curves[i].is_selected)
            highlighted.push_back(i);
    if (highlighted.empty() && count > 0)
        highlighted.push_back(count - 1);
    return highlighted;
}

Vec3f curve_color(std::size_t curve)
{
    auto const& colors = theme::palette().curves;
    return colors[curve % colors.size()];
}

Bounds strokes_box(view::WindowState const& state)
{
    // Enlarges the box's base, because the camera only fits an upright cylinder inside the box, and
    // would cut off the grid's corners.
    constexpr double kAround = 1.25;
    // Space above the curves for the view's title, as a share of the box's height.
    constexpr double kAbove = 0.12;
    auto const grid = ground_grid(state);
    auto box = curves_box(state);
    Vec2 const middle_mm = ((grid.low_mm + grid.high_mm) / 2).cast<double>();
    Vec2 const half_mm = kAround * ((grid.high_mm - grid.low_mm) / 2).cast<double>();
    box.min_mm.head<2>() = middle_mm - half_mm;
    box.max_mm.head<2>() = middle_mm + half_mm;
    box.max_mm.z() += kAbove * (box.max_mm.z() - box.min_mm.z());
    return box;
}

std::vector<render::Curve> stroke_curves(view::WindowState const& state,
                                         std::vector<std::size_t> const& highlighted)
{
    float const thinnest_mm = kThinnest * diagonal_mm(strokes_box(state));
    std::vector<render::Curve> curves;
    for (std::size_t i = 0; i < state.curves.size(); ++i) {
        auto const& line = state.curves[i].line;
        if (line.points.empty())
            continue;
        float const factor = std::ranges::find(highlighted, i) != highlighted.end() ? kWider : 1.0f;
        auto const color = curve_color(i);
        render::Curve curve;
        curve.width_unit = render::Curve::WidthUnit::Millimetres;
        if (line.look == tools::InkStyle::Look::Arrow)
            curve.end = render::Curve::End::Arrow;
        for (auto const& point : line.points)
            curve.points.push_back(
                { point.position_mm, color, factor * std::max(point.width_mm, thinnest_mm) });
        auto dot = curve.points.front();
        dot.width *= kDotSize;
        curves.push_back(std::move(curve));
        curves.push_back(
            { .points = { dot }, .width_unit = render::Curve::WidthUnit::Millimetres });
    }
    return curves;
}

std::vector<render::Curve> live_stroke_curves(view::WindowState const& state)
{
    float const thinnest_mm = kThinnest * diagonal_mm(strokes_box(state));
    auto const T_world_pad = pad_of_world(state).inverse();
    std::vector<render::Curve> curves;
    for (auto const& line : state.live_ink) {
        auto& curve = curves.emplace_back();
        curve.width_unit = render::Curve::WidthUnit::Millimetres;
        for (auto const& point : line.points)
            curve.points.push_back({ T_world_pad * point.position_mm, theme::palette().ink,
                                     std::max(point.width_mm, thinnest_mm) });
    }
    return curves;
}

std::vector<render::Curve> ground_curves(view::WindowState const& state,
                                         std::vector<std::size_t> const& highlighted)
{
    auto const grid = ground_grid(state);
    std::vector<render::Curve> curves;
    add_grid(grid, curves);
    add_upright(state, grid, curves);
    // Only the newest curves have a drop line, as there may be a thousand curves.
    auto const first = highlighted.size() - std::min(highlighted.size(), kMaxDropLines);
    for (auto i = first; i < highlighted.size(); ++i) {
        auto const& points = state.curves[highlighted[i]].line.points;
        if (points.empty())
            continue;
        auto const& start_mm = points.front().position_mm;
        curves.push_back(thin_line(start_mm, { start_mm.x(), start_mm.y(), grid.height_mm },
                                   theme::palette().unselected, 1));
    }
    return curves;
}

Vec3f front_mm(view::WindowState const& state)
{
    auto const grid = ground_grid(state);
    return { (grid.low_mm.x() + grid.high_mm.x()) / 2, grid.low_mm.y(), grid.height_mm };
}

PictureProjection::PictureProjection(render::Camera const& camera, Vec2f const& size_px)
    : clip_of_world_(
        render::projection_matrix(camera, static_cast<double>(size_px.x() / size_px.y()))
        * render::T_camera_world(camera))
    , size_px_(size_px)
{
}

std::optional<Vec2f> PictureProjection::to_px(Vec3f const& point_mm) const
{
    Eigen::Vector4f const clip = clip_of_world_ * point_mm.homogeneous();
    if (clip.w() <= 0)
        return std::nullopt;
    return Vec2f((1 + clip.x() / clip.w()) / 2 * size_px_.x(),
                 (1 - clip.y() / clip.w()) / 2 * size_px_.y());
}

std::optional<std::size_t> curve_at(std::span<view::DrawnCurveView const> curves,
                                    PictureProjection const& projection, Vec2f const& place_px,
                                    float reach_px)
{
    std::optional<std::size_t> nearest;
    float least = reach_px * reach_px;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        bool has_last = false; // True if the previous point of the curve is in front of the camera.
        Vec2f last = Vec2f::Zero();
        for (auto const& point : curves[i].line.points) {
            auto const here = projection.to_px(point.position_mm);
            float const squared = here && has_last
                ? squared_distance_to_segment(place_px, last, *here)
                : std::numeric_limits<float>::max();
            if (squared <= least) {
                least = squared;
                nearest = i;
            }
            has_last = here.has_value();
            last = here.value_or(last);
        }
    }
    return nearest;
}

std::vector<CurveLabel> curve_labels(std::span<view::DrawnCurveView const> curves,
                                     std::vector<std::size_t> const& highlighted,
                                     PictureProjection const& projection, Vec2f const& label_px)
{
    std::vector<std::size_t> order(highlighted.rbegin(), highlighted.rend());
    for (auto i = curves.size(); i-- > 0;)
        order.push_back(i);
    std::vector<bool> is_placed(curves.size(), false);
    std::vector<CurveLabel> labels;
    for (auto const curve : order) {
        if (is_placed[curve] || curves[curve].line.points.empty())
            continue;
        is_placed[curve] = true;
        auto const start_px = projection.to_px(curves[curve].line.points.front().position_mm);
        if (!start_px)
            continue;
        Vec2f const corner_px = *start_px + Vec2f(label_px.y() / 3, -1.1f * label_px.y());
        bool const is_free = std::ranges::none_of(labels, [&](CurveLabel const& other) {
            Vec2f const apart_px = (other.corner_px - corner_px).cwiseAbs();
            return apart_px.x() < label_px.x() && apart_px.y() < label_px.y();
        });
        if (is_free)
            labels.push_back({ curve, corner_px });
    }
    return labels;
}

} // namespace tractus::window
