#include "app/window/view_curves.h"

#include "app/window/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus::window {

namespace {

using Point = render::Curve::Point;

render::Curve line(Vec3f const& from, Vec3f const& to, Vec3f const& color, float width_px)
{
    render::Curve curve;
    curve.look = render::Curve::Look::Flat;
    curve.points = { { from, color, width_px }, { to, color, width_px } };
    return curve;
}

void add_surface_grid(view::WindowState const& state, std::vector<render::Curve>& curves)
{
    Vec3f const low = state.volume_mm.min_mm.cast<float>();
    Vec3f const high = state.volume_mm.max_mm.cast<float>();
    auto const height = static_cast<float>(state.surface_height_mm);
    float const step = grid_step_mm((high - low).head<2>().maxCoeff());
    for (float x = std::ceil(low.x() / step) * step; x <= high.x(); x += step)
        curves.push_back(
            line({ x, low.y(), height }, { x, high.y(), height }, theme::palette().grid, 1));
    for (float y = std::ceil(low.y() / step) * step; y <= high.y(); y += step)
        curves.push_back(
            line({ low.x(), y, height }, { high.x(), y, height }, theme::palette().grid, 1));
}

// Adds the outline of the drawing volume's floor, and the edges from the surface down to it.
void add_volume(view::WindowState const& state, std::vector<render::Curve>& curves)
{
    Vec3f const low = state.volume_mm.min_mm.cast<float>();
    Vec3f const high = state.volume_mm.max_mm.cast<float>();
    auto const height = static_cast<float>(state.surface_height_mm);
    std::array<Vec2f, 4> const corners { low.head<2>(), Vec2f(high.x(), low.y()), high.head<2>(),
                                         Vec2f(low.x(), high.y()) };
    for (std::size_t i = 0; i < 4; ++i) {
        auto const& corner = corners[i];
        auto const& next = corners[(i + 1) % 4];
        Vec3f const floor(corner.x(), corner.y(), low.z());
        curves.push_back(
            line(floor, { next.x(), next.y(), low.z() }, theme::palette().volume, 1.5f));
        curves.push_back(
            line(floor, { corner.x(), corner.y(), height }, theme::palette().volume, 1.5f));
    }
}

// Returns the colour of the ink. An eraser's stroke is faint, as it only shows where the eraser
// went.
Vec3f ink_color(tools::InkStyle::Look look, Vec3f const& color)
{
    switch (look) {
    case tools::InkStyle::Look::Arrow:
        return theme::palette().indicator;
    case tools::InkStyle::Look::Eraser:
        return 0.2f * theme::palette().unselected + 0.8f * theme::palette().pad_background;
    case tools::InkStyle::Look::Line:
        break;
    }
    return color;
}

void add_ink(std::vector<view::InkLine> const& lines, Vec3f const& color,
             std::vector<render::Curve>& curves)
{
    for (auto const& ink : lines) {
        auto& curve = curves.emplace_back();
        curve.width_unit = render::Curve::WidthUnit::Millimetres;
        curve.look = render::Curve::Look::Flat;
        curve.fades = true;
        if (ink.look == tools::InkStyle::Look::Arrow)
            curve.end = render::Curve::End::Arrow;
        for (auto const& point : ink.points)
            curve.points.push_back(
                { point.position_mm, ink_color(ink.look, color), point.width_mm });
    }
}

// Cuts a line into dashes of the length `drawn_mm`, with gaps of `left_out_mm`.
std::vector<std::vector<Vec3f>> dashes(std::vector<Vec3f> const& points_mm, float drawn_mm,
                                       float left_out_mm)
{
    std::vector<std::vector<Vec3f>> parts { { points_mm.front() } };
    bool draws = true;
    float to_go_mm = drawn_mm;
    for (std::size_t i = 1; i < points_mm.size(); ++i) {
        Vec3f from_mm = points_mm[i - 1];
        for (float way_mm = (points_mm[i] - from_mm).norm(); way_mm > to_go_mm;
             way_mm = (points_mm[i] - from_mm).norm()) {
            from_mm += (points_mm[i] - from_mm) * (to_go_mm / way_mm);
            if (draws)
                parts.back().push_back(from_mm);
            else
                parts.push_back({ from_mm });
            draws = !draws;
            to_go_mm = draws ? drawn_mm : left_out_mm;
        }
        to_go_mm -= (points_mm[i] - from_mm).norm();
        if (draws)
            parts.back().push_back(points_mm[i]);
    }
    if (parts.back().size() < 2)
        parts.pop_back();
    return parts;
}

// Adds a refused stroke. It is faint and dashed, because it only illustrates the reason beside it
// and is not part of the plant.
void add_refused(view::RefusedStroke const& refused, std::vector<render::Curve>& curves)
{
    Vec3f const color = 0.5f * theme::palette().ink + 0.5f * theme::palette().pad_background;
    std::vector<Vec3f> points_mm;
    for (auto const& point : refused.ink.points)
        points_mm.push_back(point.position_mm);
    constexpr float kDash_mm = 4;
    for (auto const& part_mm : dashes(points_mm, kDash_mm, kDash_mm)) {
        auto& curve = curves.emplace_back();
        curve.look = render::Curve::Look::Flat;
        for (auto const& point_mm : part_mm)
            curve.points.push_back({ point_mm, color, 2 });
    }
}

void add_pen(view::WindowState const& state, std::vector<render::Curve>& curves)
{
    if (!state.pen.in_range)
        return;
    auto const& tip = state.pen.tip_mm;
    Vec3f const foot(tip.x(), tip.y(), static_cast<float>(state.volume_mm.min_mm.z()));
    Vec3f const color = state.pen.touching ? theme::palette().ink : theme::palette().unselected;
    auto& drop = curves.emplace_back(line(tip, foot, theme::palette().unselected, 2));
    drop.points[1].color = theme::palette().volume;
    curves.push_back({ .points = { { foot, theme::palette().volume, 9 } } });
    curves.push_back({ .points = { { tip, color, state.pen.touching ? 18.0f : 12.0f } } });
}

Vec3f state_color(tools::SkeletonLine::State state)
{
    switch (state) {
    case tools::SkeletonLine::State::Unselected:
        return theme::palette().unselected;
    case tools::SkeletonLine::State::Undetermined:
        return theme::palette().undetermined;
    case tools::SkeletonLine::State::Selected:
        return theme::palette().selected;
    case tools::SkeletonLine::State::Assigned:
        return theme::palette().assigned;
    case tools::SkeletonLine::State::Next:
        return theme::palette().ink;
    case tools::SkeletonLine::State::Other:
        return theme::palette().faint;
    }
    return theme::palette().unselected;
}

// Returns the greatest width of the skeleton's lines or, without a skeleton, of the preview's.
float widest_mm(view::WindowState const& state)
{
    float widest = 1e-3f;
    for (auto const& line : state.skeleton.empty() ? state.preview : state.skeleton)
        widest = std::max(widest, line.width_mm);
    return widest;
}

// Returns the width of a skeleton line. Trunks are thick, but no line is too thin to see or select.
float width_px(tools::SkeletonLine const& line, float widest)
{
    // A previewed branch may be wider than all branches of the skeleton.
    float const plain = 1.6f + 5.0f * std::sqrt(std::min(line.width_mm / widest, 4.0f));
    bool const is_plain = line.state == tools::SkeletonLine::State::Unselected
        || line.state == tools::SkeletonLine::State::Other;
    return is_plain ? plain : plain * 1.3f + 1.5f;
}

void add_ground_ring(std::vector<tools::SkeletonLine> const& skeleton,
                     std::vector<render::Curve>& curves)
{
    float radius = 0;
    for (auto const& line : skeleton)
        for (auto const& point : line.points_mm)
            radius = std::max(radius, point.head<2>().norm());
    if (radius <= 0)
        return;
    constexpr int kPieces = 72;
    for (float const share : { 0.35f, 0.7f }) {
        auto& ring = curves.emplace_back();
        ring.look = render::Curve::Look::Flat;
        for (int i = 0; i <= kPieces; ++i) {
            float const angle = static_cast<float>(i) * static_cast<float>(2 * kPi) / kPieces;
            ring.points.push_back({ Vec3f(std::cos(angle), std::sin(angle), 0) * (radius * share),
                                    theme::palette().grid, 1.5f });
        }
    }
}

void add_flat_line(view::WindowState const& state, tools::SkeletonLine const& line,
                   Vec3f const& color, std::vector<render::Curve>& curves)
{
    auto& curve = curves.emplace_back();
    curve.look = render::Curve::Look::Flat;
    curve.points.reserve(line.points_mm.size());
    auto const T_pad_plant = pad_of_world(state) * state.T_world_plant;
    for (auto const& point : line.points_mm)
        curve.points.push_back({ T_pad_plant * point, color, 1.5f });
}

std::vector<std::vector<Vec3f>> with_pattern(std::vector<Vec3f> const& line_mm,
                                             tools::LayerStyle const& style)
{
    constexpr float kMaxDashes = 300; // Maximum number of dashes of a line, however long it is.
    float length_mm = 0;
    for (std::size_t i = 1; i < line_mm.size(); ++i)
        length_mm += (line_mm[i] - line_mm[i - 1]).norm();
    auto const width_mm = static_cast<float>(style.width_mm);
    switch (style.pattern) {
    case tools::LayerStyle::Pattern::Dashed: {
        float const drawn_mm = std::max(4 * width_mm, length_mm / kMaxDashes);
        return dashes(line_mm, drawn_mm, 0.6f * drawn_mm);
    }
    case tools::LayerStyle::Pattern::Dotted: {
        float const drawn_mm = std::max(width_mm, length_mm / kMaxDashes);
        return dashes(line_mm, drawn_mm, 1.5f * drawn_mm);
    }
    case tools::LayerStyle::Pattern::Solid:
        break;
    }
    return { line_mm };
}

// Returns the lines that the visible layers show with the plant (tools::Layer), as curves in the
// world frame. Line widths are in millimetres.
std::vector<render::Curve> layer_curves(view::WindowState const& state)
{
    std::vector<render::Curve> curves;
    for (auto const& [layer, lines_mm, strength] : state.layers) {
        auto const& style = layer->style;
        auto const share = static_cast<float>(strength);
        Vec3f const color
            = share * layer_color(style) + (1 - share) * theme::palette().pad_background;
        for (auto const& line_mm : lines_mm)
            for (auto const& part_mm : with_pattern(line_mm, style)) {
                auto& curve = curves.emplace_back();
                if (style.end == tools::LayerStyle::End::Arrow)
                    curve.end = render::Curve::End::Arrow;
                for (auto const& point_mm : part_mm)
                    curve.points.push_back({ point_mm, color, static_cast<float>(style.width_mm) });
            }
    }
    return curves;
}

// Width of a layer's lines in the skeleton's view, in pixels per millimetre of the layer's line
// width.
constexpr float kLayerWidth_px_per_mm = 1.45f;

} // namespace

float grid_step_mm(float extent_mm)
{
    float const rough = std::max(extent_mm, 1.0f) / 12;
    float const power = std::pow(10.0f, std::floor(std::log10(rough)));
    for (float const factor : { 1.0f, 2.0f, 5.0f })
        if (rough <= power * factor)
            return power * factor;
    return power * 10;
}

bool draws_on_paper(view::WindowState const& state)
{
    return state.is_paper_upright || state.hand.kind().surface == tools::Surface::Paper;
}

Eigen::Affine3f pad_of_world(view::WindowState const& state)
{
    Eigen::Affine3f T_pad_world = Eigen::Affine3f::Identity();
    if (!draws_on_paper(state))
        return T_pad_world;
    auto const& paper = state.preview_paper ? *state.preview_paper : state.paper;
    T_pad_world.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    T_pad_world.linear() /= static_cast<float>(paper.unit);
    Vec3 const world_point_mm = paper.world_point_mm / paper.unit;
    T_pad_world.translation()
        = Vec3(paper.base_mm.x() - world_point_mm.x(), paper.base_mm.y() - world_point_mm.z(),
               state.surface_height_mm + world_point_mm.y())
              .cast<float>();
    return T_pad_world;
}

Vec3f layer_color(tools::LayerStyle const& style)
{
    auto const& palette = theme::palette();
    switch (style.color) {
    case tools::LayerStyle::Color::Orange:
        return palette.indicator;
    case tools::LayerStyle::Color::Blue:
        return palette.selected;
    case tools::LayerStyle::Color::Green:
        return palette.assigned;
    case tools::LayerStyle::Color::Purple:
        return palette.purple;
    case tools::LayerStyle::Color::Grey:
        break;
    }
    return palette.unselected;
}

std::vector<render::Curve> pad_skeleton_curves(view::WindowState const& state)
{
    std::vector<render::Curve> curves;
    for (auto const& line : state.skeleton) {
        bool const is_plain = line.state == tools::SkeletonLine::State::Unselected
            || line.state == tools::SkeletonLine::State::Other;
        Vec3f const color = is_plain
            ? theme::palette().faint
            : Vec3f(0.45f * state_color(line.state) + 0.55f * theme::palette().pad_background);
        add_flat_line(state, line, color, curves);
    }
    return curves;
}

std::vector<render::Curve> pad_preview_curves(view::WindowState const& state)
{
    std::vector<render::Curve> curves;
    for (auto const& line : state.preview)
        add_flat_line(state, line,
                      0.45f * state_color(line.state) + 0.55f * theme::palette().pad_background,
                      curves);
    return curves;
}

std::vector<render::Curve> pad_stroke_curves(view::WindowState const& state)
{
    std::vector<render::Curve> curves;
    add_ink(state.strokes, theme::palette().stroke, curves);
    for (auto& curve : layer_curves(state)) {
        curve.width_unit = render::Curve::WidthUnit::Millimetres;
        curve.look = render::Curve::Look::Flat;
        curve.fades = true;
        curves.push_back(std::move(curve));
    }
    auto const T_pad_world = pad_of_world(state);
    for (auto& curve : curves)
        for (auto& point : curve.points)
            point.position_mm = T_pad_world * point.position_mm;
    return curves;
}

std::vector<render::Curve> pad_live_curves(view::WindowState const& state)
{
    std::vector<render::Curve> curves;
    add_volume(state, curves);
    add_surface_grid(state, curves);
    auto const surface = state.hand.kind().surface;
    if (surface == tools::Surface::Space || surface == tools::Surface::Paper)
        add_ink(state.live_ink, theme::palette().ink, curves);
    if (state.refused && state.refused->surface == surface && surface != tools::Surface::Skeleton)
        add_refused(*state.refused, curves);
    add_pen(state, curves);
    return curves;
}

render::Stage::Fade pad_fade(view::WindowState const& state)
{
    auto const range = static_cast<float>(state.volume_mm.max_mm.z() - state.volume_mm.min_mm.z());
    return { .color = theme::palette().pad_background,
             .share = 0.55f,
             .from_mm = static_cast<float>(state.surface_height_mm),
             .range_mm = std::max(range, 1.0f) };
}

SkeletonStates skeleton_states(view::WindowState const& state)
{
    SkeletonStates states;
    for (auto const& line : state.skeleton) {
        states.selected |= line.state == tools::SkeletonLine::State::Selected;
        states.undetermined |= line.state == tools::SkeletonLine::State::Undetermined;
        states.assigned |= line.state == tools::SkeletonLine::State::Assigned;
        states.next |= line.state == tools::SkeletonLine::State::Next;
    }
    for (auto const& shown : state.layers)
        states.layers.push_back(shown.layer);
    return states;
}

std::vector<render::Curve> preview_curves(view::WindowState const& state)
{
    float const widest = widest_mm(state);
    std::vector<render::Curve> curves;
    for (auto const& line : state.preview) {
        auto& curve = curves.emplace_back();
        curve.points.reserve(line.points_mm.size());
        for (auto const& point : line.points_mm)
            curve.points.push_back({ point, state_color(line.state), width_px(line, widest) });
    }
    return curves;
}

std::vector<render::Curve> underground_curves(view::WindowState const& state)
{
    constexpr float kUndergroundWidth_px = 3;
    std::vector<render::Curve> curves;
    for (auto const& points_mm : state.underground_mm)
        curves.push_back(line(points_mm.front(), points_mm.back(), theme::palette().indicator,
                              kUndergroundWidth_px));
    return curves;
}

std::vector<render::Curve> growing_curves(view::WindowState const& state)
{
    // Least width of a line, as a share of the diagonal of the plant's box. Lines without a width
    // would be invisible.
    constexpr double kThinnestShare = 1.0 / 400;
    auto const& box_mm = state.skeleton_box_mm;
    float const thinnest_mm = box_mm.empty()
        ? 0
        : static_cast<float>(kThinnestShare * (box_mm.max_mm - box_mm.min_mm).norm());
    std::vector<render::Curve> curves;
    for (auto const& line : state.preview) {
        auto& curve = curves.emplace_back();
        curve.width_unit = render::Curve::WidthUnit::Millimetres;
        curve.points.reserve(line.points_mm.size());
        for (auto const& point : line.points_mm)
            curve.points.push_back(
                { point, theme::palette().growing, std::max(line.width_mm, thinnest_mm) });
    }
    return curves;
}

std::vector<render::Curve> skeleton_curves(view::WindowState const& state)
{
    std::vector<render::Curve> curves;
    add_ground_ring(state.skeleton, curves);
    float const widest = widest_mm(state);
    for (auto const& line : state.skeleton) {
        auto& curve = curves.emplace_back();
        curve.points.reserve(line.points_mm.size());
        for (auto const& point : line.points_mm)
            curve.points.push_back({ point, state_color(line.state), width_px(line, widest) });
    }
    auto const T_plant_world = state.T_world_plant.inverse();
    for (auto& curve : layer_curves(state)) {
        for (auto& point : curve.points) {
            point.position_mm = T_plant_world * point.position_mm;
            point.width *= kLayerWidth_px_per_mm;
        }
        curves.push_back(std::move(curve));
    }
    return curves;
}

} // namespace tractus::window
