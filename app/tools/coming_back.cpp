#include "app/tools/coming_back.h"

#include <algorithm>

namespace tractus::tools {

bool is_coming_back(std::span<TipSample const> ink)
{
    Vec2 const begin = ink.front().position_mm.head<2>();
    double farthest = 0;
    for (auto const& tip : ink)
        farthest = std::max(farthest, (tip.position_mm.head<2>() - begin).norm());
    return (ink.back().position_mm.head<2>() - begin).norm() < 0.7 * farthest;
}

} // namespace tractus::tools
