#include "engine/stroke/foot_first.h"

#include "engine/stroke/derived_tips.h"

#include <algorithm>
#include <vector>

namespace tractus {

bool is_drawn_to_foot(std::span<Vec3 const> tips_mm, std::optional<double> ground_mm)
{
    // Minimum descent of the stroke, as a share of the distance from its first point to its last.
    constexpr double kDown = 0.7;
    // Maximum depth of the stroke below its last point, as a share of its descent.
    constexpr double kAbove = 0.1;
    // Maximum height of the stroke's last point above the ground, as a share of its descent.
    constexpr double kGround = 0.3;
    if (tips_mm.size() < 2)
        return false;
    Vec3 const way_mm = tips_mm.back() - tips_mm.front();
    double const descent_mm = -way_mm.z();
    if (!(descent_mm > 0) || descent_mm < kDown * way_mm.norm())
        return false;
    double const end_mm = tips_mm.back().z();
    if (ground_mm && end_mm > *ground_mm + kGround * descent_mm)
        return false;
    return std::all_of(tips_mm.begin(), tips_mm.end(), [&](Vec3 const& tip_mm) {
        return tip_mm.z() >= end_mm - kAbove * descent_mm;
    });
}

bool is_drawn_to_foot_of(std::span<Vec3 const> tips_mm, Vec3 const& foot_mm, Vec3 const& tip_mm)
{
    // Maximum distance of the stroke's end from the foot, as a share of its beginning's distance.
    constexpr double kAtFoot = 0.15;
    if (tips_mm.size() < 2)
        return false;
    double const begin_mm = (tips_mm.front() - foot_mm).norm();
    double const end_mm = (tips_mm.back() - foot_mm).norm();
    return end_mm < kAtFoot * begin_mm && (tips_mm.front() - tip_mm).norm() < begin_mm;
}

Stroke turned_round(Stroke const& stroke)
{
    return { { reversed_tips(stroke.tips.vector()), reversed_source(stroke.tips.source()) } };
}

} // namespace tractus
