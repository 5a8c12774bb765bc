#include "engine/export/relief_tile.h"

#include <algorithm>

namespace tractus::exports {

ReliefTile::ReliefTile(int side, std::vector<double> heights)
    : side_(side)
    , heights_(std::move(heights))
{
    find_means();
}

Vec3 ReliefTile::normal(int column, int row, double depth) const
{
    double const per_step = 0.5 * side_ * depth;
    double const slope_u = per_step * (at(column + 1, row) - at(column - 1, row));
    double const slope_v = per_step * (at(column, row + 1) - at(column, row - 1));
    Vec3 const normal = Vec3(-slope_u, slope_v, 1).normalized();
    return 0.5 * (normal + Vec3::Ones());
}

double ReliefTile::openness(int column, int row) const
{
    double const depth = means_[index(column, row)] - at(column, row);
    return std::clamp(1 - 2 * std::max(depth, 0.0), 0.3, 1.0);
}

// Uses a box filter along the rows, then along the columns.
void ReliefTile::find_means()
{
    constexpr int kTaps = 7;
    // 4 of 512 pixels.
    int const step = std::max(side_ / 128, 1);
    int const reach = step * (kTaps / 2);
    auto along = heights_;
    means_.resize(heights_.size());
    auto const mean = [&](auto const& value_at) {
        double total = 0;
        for (int i = -reach; i <= reach; i += step)
            total += value_at(i);
        return total / kTaps;
    };
    for (int row = 0; row < side_; ++row)
        for (int column = 0; column < side_; ++column)
            along[index(column, row)] = mean([&](int x) { return at(column + x, row); });
    for (int row = 0; row < side_; ++row)
        for (int column = 0; column < side_; ++column)
            means_[index(column, row)] = mean([&](int y) { return along[index(column, row + y)]; });
}

} // namespace tractus::exports
