#include "app/window/view_curves.h"

#include "app/window/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus {

namespace {

using Point = Curve::Point;

Curve line(Vec3f const& from, Vec3f const& to, Vec3f const& color, float width_px)
{
    Curve curve;
    curve.look = Curve::Look::Flat;
    curve.points = { { from, color, width_px }, { to, color, width_px } };
    return curve;
}

// A distance between grid lines that reads well: 1, 2 or 5 times a power of ten, about a twelfth of
// the extent.
float grid_step_mm(float extent_mm)
{
    float const rough = std::max(extent_mm, 1.0f) / 12;
    float const power = std::pow(10.0f, std::floor(std::log10(rough)));
    for (float const factor : { 1.0f, 2.0f, 5.0f })
        if (rough <= power * factor)
            return power * factor;
    return power * 10;
}

void add_surface_grid(WindowState const& state, std::vector<Curve>& curves)
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

// The floor's rim and the edges that lead down to it.
void add_volume(WindowState const& state, std::vector<Curve>& curves)
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

// The eraser leaves nothing behind but that one sees where it was.
Vec3f ink_color(InkStyle::Look look, Vec3f const& color)
{
    switch (look) {
    case InkStyle::Look::Arrow:
        return theme::palette().indicator;
    case InkStyle::Look::Eraser:
        return 0.2f * theme::palette().unselected + 0.8f * theme::palette().pad_background;
    case InkStyle::Look::Line:
        break;
    }
    return color;
}

void add_ink(std::vector<InkLine> const& lines, Vec3f const& color, std::vector<Curve>& curves)
{
    for (auto const& ink : lines) {
        auto& curve = curves.emplace_back();
        curve.width_unit = Curve::WidthUnit::Millimetres;
        curve.look = Curve::Look::Flat;
        curve.fades = true;
        if (ink.look == InkStyle::Look::Arrow)
            curve.end = Curve::End::Arrow;
        for (auto const& point : ink.points)
            curve.points.push_back(
                { point.position_mm, ink_color(ink.look, color), point.width_mm });
    }
}

void add_pen(WindowState const& state, std::vector<Curve>& curves)
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

Vec3f state_color(SkeletonLine::State state)
{
    switch (state) {
    case SkeletonLine::State::Unselected:
        return theme::palette().unselected;
    case SkeletonLine::State::Undetermined:
        return theme::palette().undetermined;
    case SkeletonLine::State::Selected:
        return theme::palette().selected;
    case SkeletonLine::State::Assigned:
        return theme::palette().assigned;
    case SkeletonLine::State::Other:
        return theme::palette().faint;
    }
    return theme::palette().unselected;
}

float widest_mm(std::vector<SkeletonLine> const& skeleton)
{
    float widest = 1e-3f;
    for (auto const& line : skeleton)
        widest = std::max(widest, line.width_mm);
    return widest;
}

// Thick for trunks, and never too thin to see or to hit.
float width_px(SkeletonLine const& line, float widest)
{
    float const plain = 1.6f + 5.0f * std::sqrt(line.width_mm / widest);
    bool const is_plain
        = line.state == SkeletonLine::State::Unselected || line.state == SkeletonLine::State::Other;
    return is_plain ? plain : plain * 1.3f + 1.5f;
}

void add_ground_ring(std::vector<SkeletonLine> const& skeleton, std::vector<Curve>& curves)
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
        ring.look = Curve::Look::Flat;
        for (int i = 0; i <= kPieces; ++i) {
            float const angle = static_cast<float>(i) * static_cast<float>(2 * kPi) / kPieces;
            ring.points.push_back({ Vec3f(std::cos(angle), std::sin(angle), 0) * (radius * share),
                                    theme::palette().grid, 1.5f });
        }
    }
}

void add_flat_line(WindowState const& state, SkeletonLine const& line, Vec3f const& color,
                   std::vector<Curve>& curves)
{
    auto& curve = curves.emplace_back();
    curve.look = Curve::Look::Flat;
    curve.points.reserve(line.points_mm.size());
    for (auto const& point : line.points_mm)
        curve.points.push_back({ state.T_world_plant * point, color, 1.5f });
}

} // namespace

std::vector<Curve> pad_skeleton_curves(WindowState const& state)
{
    std::vector<Curve> curves;
    for (auto const& line : state.skeleton) {
        bool const is_plain = line.state == SkeletonLine::State::Unselected
            || line.state == SkeletonLine::State::Other;
        Vec3f const color = is_plain
            ? theme::palette().faint
            : Vec3f(0.45f * state_color(line.state) + 0.55f * theme::palette().pad_background);
        add_flat_line(state, line, color, curves);
    }
    return curves;
}

std::vector<Curve> pad_preview_curves(WindowState const& state)
{
    std::vector<Curve> curves;
    for (auto const& line : state.preview)
        add_flat_line(state, line,
                      0.45f * state_color(line.state) + 0.55f * theme::palette().pad_background,
                      curves);
    return curves;
}

std::vector<Curve> pad_stroke_curves(WindowState const& state)
{
    std::vector<Curve> curves;
    add_ink(state.strokes, theme::palette().stroke, curves);
    return curves;
}

std::vector<Curve> pad_live_curves(WindowState const& state)
{
    std::vector<Curve> curves;
    add_volume(state, curves);
    add_surface_grid(state, curves);
    if (state.hand.kind().surface == Surface::Space)
        add_ink(state.live_ink, theme::palette().ink, curves);
    add_pen(state, curves);
    return curves;
}

Stage::Fade pad_fade(WindowState const& state)
{
    auto const range = static_cast<float>(state.volume_mm.max_mm.z() - state.volume_mm.min_mm.z());
    return { .color = theme::palette().pad_background,
             .share = 0.55f,
             .from_mm = static_cast<float>(state.surface_height_mm),
             .range_mm = std::max(range, 1.0f) };
}

SkeletonStates skeleton_states(WindowState const& state)
{
    SkeletonStates states;
    for (auto const& line : state.skeleton) {
        states.selected |= line.state == SkeletonLine::State::Selected;
        states.undetermined |= line.state == SkeletonLine::State::Undetermined;
        states.assigned |= line.state == SkeletonLine::State::Assigned;
    }
    states.leaning = !state.indicators.empty();
    return states;
}

std::vector<Curve> preview_curves(WindowState const& state)
{
    float const widest = widest_mm(state.skeleton);
    std::vector<Curve> curves;
    for (auto const& line : state.preview) {
        auto& curve = curves.emplace_back();
        curve.points.reserve(line.points_mm.size());
        for (auto const& point : line.points_mm)
            curve.points.push_back({ point, state_color(line.state), width_px(line, widest) });
    }
    return curves;
}

std::vector<Curve> skeleton_curves(WindowState const& state)
{
    std::vector<Curve> curves;
    add_ground_ring(state.skeleton, curves);
    float const widest = widest_mm(state.skeleton);
    for (auto const& line : state.skeleton) {
        auto& curve = curves.emplace_back();
        curve.points.reserve(line.points_mm.size());
        for (auto const& point : line.points_mm)
            curve.points.push_back({ point, state_color(line.state), width_px(line, widest) });
    }
    for (auto const& arrow : state.indicators) {
        auto& curve = curves.emplace_back();
        curve.end = Curve::End::Arrow;
        curve.points = { { arrow.from_mm, theme::palette().indicator, 5 },
                         { arrow.to_mm, theme::palette().indicator, 5 } };
    }
    return curves;
}

} // namespace tractus
