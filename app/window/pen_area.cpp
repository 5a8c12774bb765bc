#include "app/window/pen_area.h"

#include <algorithm>

namespace tractus::window {

ImVec2 PenArea::to_px(Vec2 const& place_mm) const
{
    Vec2 const from_middle = (place_mm - middle_mm) * px_per_mm;
    return { middle_px.x + static_cast<float>(from_middle.x()),
             middle_px.y - static_cast<float>(from_middle.y()) };
}

Vec2 PenArea::to_mm(ImVec2 const& place_px) const
{
    Vec2 const from_middle(place_px.x - middle_px.x, middle_px.y - place_px.y);
    return middle_mm + from_middle / px_per_mm;
}

float PenArea::left_px() const
{
    return middle_px.x - static_cast<float>(size_mm.x() * px_per_mm / 2);
}

float PenArea::right_px() const
{
    return middle_px.x + static_cast<float>(size_mm.x() * px_per_mm / 2);
}

PenArea fit_pen_area(Bounds const& volume_mm, ImVec2 const& corner_px, ImVec2 const& size_px,
                     double air)
{
    PenArea area;
    area.middle_px = { corner_px.x + size_px.x / 2, corner_px.y + size_px.y / 2 };
    area.middle_mm = ((volume_mm.min_mm + volume_mm.max_mm) / 2).head<2>();
    area.size_mm = (volume_mm.max_mm - volume_mm.min_mm).head<2>().cwiseMax(1);
    area.px_per_mm = std::max(1e-3,
                              std::min(static_cast<double>(size_px.x) / area.size_mm.x(),
                                       static_cast<double>(size_px.y) / area.size_mm.y())
                                  / air);
    return area;
}

} // namespace tractus::window
