#include "engine/scene/desk_placement.h"

#include <algorithm>

namespace tractus {

// A plant without extent is shown at natural size.
static double fitting_scale(double shown_mm, double natural_mm)
{
    return natural_mm > 0 ? shown_mm / natural_mm : 1;
}

DeskPlacement place_on_desk(Plant const& plant, DrawingVolume const& volume)
{
    auto const box = bounds(plant);
    if (box.empty())
        return {};
    double const half_width_mm = std::max({ -box.min_mm.x(), box.max_mm.x(), 0.0 });
    double const half_depth_mm = std::max({ -box.min_mm.y(), box.max_mm.y(), 0.0 });
    double const height_mm = std::max(box.max_mm.z(), 0.0);
    double scale = fitting_scale(volume.height_mm, height_mm);
    if (half_width_mm > 0)
        scale = std::min(scale, fitting_scale(volume.width_mm / 2, half_width_mm));
    if (half_depth_mm > 0)
        scale = std::min(scale, fitting_scale(volume.width_mm / 2, half_depth_mm));
    return { .scale = scale, .shown_height_mm = std::max(scale * height_mm, 1.0) };
}

SelectionView fit_selection_view(Plant const& plant, DrawingVolume const& volume)
{
    constexpr double kMargin
        = 0.06; // Of the tablet's area on each side, so that tips can be passed.
    auto const box = bounds(plant);
    if (box.empty())
        return {};
    Vec2 const low(box.min_mm.x(), box.min_mm.z());
    Vec2 const high(box.max_mm.x(), box.max_mm.z());
    Vec2 const area = (1 - 2 * kMargin) * Vec2(volume.width_mm, volume.depth_mm);
    Vec2 const extent = high - low;
    double const scale = std::min(fitting_scale(area.x(), std::max(extent.x(), extent.y() * 1e-3)),
                                  fitting_scale(area.y(), extent.y()));
    return { .scale = scale, .origin_mm = -scale * (low + high) / 2 };
}

SkeletonView skeleton_view(SelectionView const& view, DrawingVolume const& volume)
{
    SkeletonView result;
    result.to_plane << view.scale, 0, 0, view.origin_mm.x(), //
        0, 0, view.scale, view.origin_mm.y(),                //
        0, 1, 0, 0,                                          // Seen along +y: farther is deeper.
        0, 0, 0, 1;
    result.max = Vec2(volume.width_mm, volume.depth_mm) / 2;
    result.min = -result.max;
    return result;
}

} // namespace tractus
