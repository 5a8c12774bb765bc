#include "engine/stroke/upright_sheet.h"

#include "engine/base/check.h"

#include <algorithm>

namespace tractus {

StrokeSurface resolve_surface(std::vector<TipSample> const& tips, StrokeSurface wanted)
{
    if (wanted != StrokeSurface::Decided || tips.empty())
        return wanted == StrokeSurface::Paper ? StrokeSurface::Paper : StrokeSurface::Space;
    constexpr double kStill = 0.05;
    double length_mm = 0;
    double lowest_mm = tips.front().position_mm.z();
    double highest_mm = lowest_mm;
    for (std::size_t i = 1; i < tips.size(); ++i) {
        Vec3 const way = tips[i].position_mm - tips[i - 1].position_mm;
        length_mm += way.head<2>().norm();
        lowest_mm = std::min(lowest_mm, tips[i].position_mm.z());
        highest_mm = std::max(highest_mm, tips[i].position_mm.z());
    }
    return highest_mm - lowest_mm < kStill * length_mm ? StrokeSurface::Paper
                                                       : StrokeSurface::Space;
}

std::vector<Vec3> plant_tips(std::vector<TipSample> const& tips, StrokeSurface surface)
{
    CHECK(surface != StrokeSurface::Decided);
    std::vector<Vec3> result;
    result.reserve(tips.size());
    for (auto const& tip : tips) {
        auto const& at_mm = tip.position_mm;
        if (surface == StrokeSurface::Space)
            result.push_back(at_mm);
        else
            result.emplace_back(at_mm.x(), tips.front().position_mm.z() - at_mm.z(), at_mm.y());
    }
    return result;
}

} // namespace tractus
