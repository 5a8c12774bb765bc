#include "engine/scene/desk_placement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tractus::scene {

// Returns the scale at which a natural size is shown as `shown_mm`; 1 if the natural size is 0.
static double fitting_scale(double shown_mm, double natural_mm)
{
    return natural_mm > 0 ? shown_mm / natural_mm : 1;
}

// Returns the highest branching order to display: the axes up to it are few enough for the pen to
// tell apart. At least 1.
static std::uint32_t sparse_order(Plant const& plant)
{
    constexpr std::size_t kMaxAxes = 60;
    std::vector<std::size_t> axes_of_order;
    for (auto const& axis : plant.axes) {
        axes_of_order.resize(std::max<std::size_t>(axes_of_order.size(), axis.order + 1));
        ++axes_of_order[axis.order];
    }
    std::size_t shown = 0;
    std::uint32_t order = 0;
    for (; order < axes_of_order.size(); ++order) {
        shown += axes_of_order[order];
        if (order > 1 && shown > kMaxAxes)
            break;
    }
    return std::max(order, 2u) - 1;
}

DeskPlacement place_on_desk(Plant const& plant, DrawingVolume const& volume)
{
    auto const box = bounds(plant);
    if (box.empty())
        return {};
    double const spread_mm
        = std::max({ -box.min_mm.x(), box.max_mm.x(), -box.min_mm.y(), box.max_mm.y(), 0.0 });
    double const height_mm = std::max(box.max_mm.z(), 0.0);
    double scale = fitting_scale(volume.height_mm, height_mm);
    if (spread_mm > 0)
        scale = std::min(scale, fitting_scale(volume.width_mm / 2, spread_mm));
    return { .scale = scale, .shown_height_mm = std::max(scale * height_mm, 1.0) };
}

void rescale(DeskPlacement& placement, double scale)
{
    if (scale == placement.scale)
        return;
    placement.shown_height_mm = std::max(placement.shown_height_mm * scale / placement.scale, 1.0);
    placement.scale = scale;
}

SelectionView fit_selection_view(Bounds const& box, SelectionAngle const& angle)
{
    // Margin on each side of the tablet, as a share of its width or height, so that strokes can
    // extend past the tips of branches.
    constexpr double kMargin = 0.06;
    SelectionView view;
    view.area_mm = angle.area_mm;
    if (box.empty())
        return view;
    double const azimuth_rad = radians(angle.azimuth_deg);
    double const elevation_rad = radians(angle.elevation_deg);
    view.right = Vec3(std::cos(azimuth_rad), std::sin(azimuth_rad), 0);
    Vec3 const flat_back(std::sin(azimuth_rad), -std::cos(azimuth_rad), 0);
    view.back = std::cos(elevation_rad) * flat_back + std::sin(elevation_rad) * Vec3::UnitZ();
    view.up = std::cos(elevation_rad) * Vec3::UnitZ() - std::sin(elevation_rad) * flat_back;
    Eigen::AlignedBox2d shown;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 const place(corner & 1 ? box.max_mm.x() : box.min_mm.x(),
                         corner & 2 ? box.max_mm.y() : box.min_mm.y(),
                         corner & 4 ? box.max_mm.z() : box.min_mm.z());
        shown.extend(Vec2(view.right.dot(place), view.up.dot(place)));
    }
    Vec2 const area = (1 - 2 * kMargin) * angle.area_mm;
    Vec2 const extent = shown.sizes();
    view.scale = angle.zoom
        * std::min(fitting_scale(area.x(), std::max(extent.x(), extent.y() * 1e-3)),
                   fitting_scale(area.y(), extent.y()));
    view.size_mm = view.scale * extent;
    view.origin_mm = angle.moved_mm - view.scale * shown.center();
    return view;
}

SelectionView fit_selection_view(Plant const& plant, SelectionAngle const& angle)
{
    auto view = fit_selection_view(bounds(plant), angle);
    if (!bounds(plant).empty())
        view.max_order = sparse_order(plant);
    return view;
}

variation::SkeletonProjection skeleton_projection(SelectionView const& view)
{
    variation::SkeletonProjection result;
    Vec3 const right = view.scale * view.right;
    Vec3 const up = view.scale * view.up;
    result.to_plane << right.x(), right.y(), right.z(), view.origin_mm.x(), //
        up.x(), up.y(), up.z(), view.origin_mm.y(),                         //
        -view.back.x(), -view.back.y(), -view.back.z(), 0, // Depth increases away from the viewer.
        0, 0, 0, 1;
    result.max = view.area_mm / 2;
    result.min = -result.max;
    result.max_order = view.max_order;
    return result;
}

} // namespace tractus::scene
