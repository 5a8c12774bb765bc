#include "app/batch/stroke_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tractus::batch {

namespace {

// Line width at the lightest pressure, as a share of the width at full pressure.
constexpr float kThinnestPart = 0.35f;

Vec3f const kSkeletonColor(0.62f, 0.60f, 0.57f);
Vec3f const kIndicatorColor(0.20f, 0.56f, 0.80f);
Vec3f const kGridColor(0.70f, 0.69f, 0.66f);

render::Curve line(Vec3 const& from, Vec3 const& to, Vec3f const& color, float width_px)
{
    render::Curve curve;
    curve.look = render::Curve::Look::Flat;
    for (auto const& end : { from, to })
        curve.points.push_back({ end.cast<float>(), color, width_px });
    return curve;
}

Vec3 world_position(scene::Scene const& scene, NodeId node)
{
    return scene.placement.world_of_plant(scene.base->node_position_mm[node]);
}

// Returns a curve along the path of branches that an association shapes. Each segment is drawn from
// its own base, so that a path that continues from an axis into a lateral has no gap.
render::Curve path_curve(scene::Scene const& scene, std::vector<SegmentId> const& path,
                         Vec3f const& color)
{
    constexpr float kWidth_px = 5;
    render::Curve curve;
    for (auto const segment : path) {
        auto const nodes = nodes_of(*scene.base, segment);
        if (curve.points.empty())
            curve.points.push_back(
                { world_position(scene, nodes.base).cast<float>(), color, kWidth_px });
        curve.points.push_back(
            { world_position(scene, nodes.tip).cast<float>(), color, kWidth_px });
    }
    return curve;
}

} // namespace

Vec3f stroke_color(std::size_t n)
{
    static std::array<Vec3f, 7> const colors {
        Vec3f(0.835f, 0.369f, 0.000f), // Vermillion, the first stroke's colour.
        Vec3f(0.000f, 0.447f, 0.698f), // Blue, the second stroke's colour.
        Vec3f(0.000f, 0.620f, 0.451f), // Bluish green, the third stroke's colour.
        Vec3f(0.800f, 0.475f, 0.655f), // Reddish purple, the fourth stroke's colour.
        Vec3f(0.902f, 0.624f, 0.000f), // Orange, the fifth stroke's colour.
        Vec3f(0.337f, 0.706f, 0.914f), // Sky blue, the sixth stroke's colour.
        // Yellow, darkened for light paper, the seventh stroke's colour.
        Vec3f(0.760f, 0.700f, 0.120f),
    };
    return colors[n % colors.size()];
}

render::Curve stroke_curve(std::vector<TipSample> const& tips, Vec3f const& color, float width_mm,
                           Nib nib)
{
    render::Curve curve;
    curve.width_unit = render::Curve::WidthUnit::Millimetres;
    curve.points.reserve(tips.size());
    for (std::size_t i = 0; i < tips.size(); ++i) {
        auto const pressed = static_cast<float>(std::clamp(tips[i].pressure, 0.0, 1.0));
        auto const broad = static_cast<float>(broadening(nib, tips, i));
        curve.points.push_back(
            { tips[i].position_mm.cast<float>(), color,
              width_mm * (kThinnestPart + (1 - kThinnestPart) * pressed) * broad });
    }
    return curve;
}

std::vector<render::Curve> skeleton_curves(scene::Scene const& scene)
{
    // Segments that a stroke shapes are left out of the axes' curves; they are drawn once, in the
    // stroke's colour.
    std::vector<bool> is_shaped(scene.base->segment_count(), false);
    for (auto const& association : scene.associations)
        for (auto const segment : association.what.path)
            is_shaped[segment] = true;

    std::vector<render::Curve> curves;
    curves.reserve(scene.base->axes.size() + scene.associations.size());
    for (auto const& axis : scene.base->axes) {
        float const width_px = axis.order == 0 ? 2.2f : axis.order == 1 ? 1.5f : 0.9f;
        render::Curve curve;
        curve.look = render::Curve::Look::Flat;
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            if (is_shaped[axis.first_segment + i]) {
                if (!curve.points.empty())
                    curves.push_back(
                        std::exchange(curve, { .points = {}, .look = render::Curve::Look::Flat }));
                continue;
            }
            auto const add = [&](NodeId node) {
                curve.points.push_back(
                    { world_position(scene, node).cast<float>(), kSkeletonColor, width_px });
            };
            if (curve.points.empty())
                add(axis.first_node + i);
            add(axis.first_node + i + 1);
        }
        if (!curve.points.empty())
            curves.push_back(std::move(curve));
    }
    for (std::size_t i = 0; i < scene.associations.size(); ++i)
        curves.push_back(path_curve(scene, scene.associations[i].what.path, stroke_color(i)));
    return curves;
}

std::vector<render::Curve> indicator_curves(scene::Scene const& scene)
{
    std::vector<render::Curve> curves;
    for (auto const& [id, indicator, at] : scene.indicators) {
        auto curve = line(indicator.start_mm, indicator.end_mm, kIndicatorColor, 4);
        curve.look = render::Curve::Look::Round;
        curve.end = render::Curve::End::Arrow;
        curves.push_back(std::move(curve));
    }
    return curves;
}

std::vector<render::Curve> desk_curves(double height_mm)
{
    constexpr double kGrid_mm = 20;
    scene::DrawingVolume const volume;
    double const half_width_mm = volume.width_mm / 2;
    double const half_depth_mm = volume.depth_mm / 2;
    std::vector<render::Curve> curves;
    for (double x = -std::floor(half_width_mm / kGrid_mm) * kGrid_mm; x <= half_width_mm;
         x += kGrid_mm)
        curves.push_back(line({ x, -half_depth_mm, height_mm }, { x, half_depth_mm, height_mm },
                              kGridColor, 0.7f));
    for (double y = -std::floor(half_depth_mm / kGrid_mm) * kGrid_mm; y <= half_depth_mm;
         y += kGrid_mm)
        curves.push_back(line({ -half_width_mm, y, height_mm }, { half_width_mm, y, height_mm },
                              kGridColor, 0.7f));
    return curves;
}

} // namespace tractus::batch
