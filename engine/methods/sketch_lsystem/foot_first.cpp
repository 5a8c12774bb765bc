#include "engine/methods/sketch_lsystem/foot_first.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace tractus::sketch {

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

Stroke turned_round(Stroke const& stroke)
{
    std::vector<TipSample> tips(stroke.tips.begin(), stroke.tips.end());
    std::reverse(tips.begin(), tips.end());
    for (std::size_t i = 0; i < tips.size() / 2; ++i)
        std::swap(tips[i].time, tips[tips.size() - 1 - i].time);
    return { std::move(tips) };
}

} // namespace tractus::sketch
