#include "engine/scene/desk_placement.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tractus {

// A plant without extent is shown at natural size.
static double fitting_scale(double shown_mm, double natural_mm)
{
    return natural_mm > 0 ? shown_mm / natural_mm : 1;
}

// The highest order up to which a plant has so few axes that a pen can tell them apart; at least 1.
static std::uint32_t sparse_order(Plant const& plant)
{
    constexpr std::size_t kMostAxes = 60;
    std::vector<std::size_t> axes_of_order;
    for (auto const& axis : plant.axes) {
        axes_of_order.resize(std::max<std::size_t>(axes_of_order.size(), axis.order + 1));
        ++axes_of_order[axis.order];
    }
    std::size_t shown = 0;
    std::uint32_t order = 0;
    for (; order < axes_of_order.size(); ++order) {
        shown += axes_of_order[order];
        if (order > 1 && shown > kMostAxes)
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

SelectionView fit_selection_view(Plant const& plant, DrawingVolume const& volume)
{
    // Of the tablet's area on each side, so that tips can be passed.
    constexpr double kMargin = 0.06;
    auto const box = bounds(plant);
    if (box.empty())
        return {};
    Vec2 const low(box.min_mm.x(), box.min_mm.z());
    Vec2 const high(box.max_mm.x(), box.max_mm.z());
    Vec2 const area = (1 - 2 * kMargin) * Vec2(volume.width_mm, volume.depth_mm);
    Vec2 const extent = high - low;
    double const scale = std::min(fitting_scale(area.x(), std::max(extent.x(), extent.y() * 1e-3)),
                                  fitting_scale(area.y(), extent.y()));
    return { .scale = scale,
             .origin_mm = -scale * (low + high) / 2,
             .max_order = sparse_order(plant) };
}

SkeletonProjection skeleton_projection(SelectionView const& view, DrawingVolume const& volume)
{
    SkeletonProjection result;
    result.to_plane << view.scale, 0, 0, view.origin_mm.x(), //
        0, 0, view.scale, view.origin_mm.y(),                //
        0, 1, 0, 0,                                          // Seen along +y: farther is deeper.
        0, 0, 0, 1;
    result.max = Vec2(volume.width_mm, volume.depth_mm) / 2;
    result.min = -result.max;
    result.max_order = view.max_order;
    return result;
}

} // namespace tractus
