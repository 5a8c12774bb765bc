#include "engine/methods/self_organising/light_grid.h"

#include "engine/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace tractus::self_organising {

namespace {

constexpr double kMaxLightCells = 1 << 24;

} // namespace

Result<LightGrid> LightGrid::make(std::span<Vec3 const> points, Laws const& laws)
{
    LightGrid grid;
    if (points.empty())
        return grid;
    std::vector<Cell> cells;
    cells.reserve(points.size());
    for (auto const& point : points)
        cells.push_back(cell_at(point, laws.cell));
    auto low = cells.front();
    auto high = low;
    for (auto const& cell : cells)
        for (std::size_t a = 0; a < 3; ++a) {
            low[a] = std::min(low[a], cell[a]);
            high[a] = std::max(high[a], cell[a]);
        }
    double count = 1;
    for (std::size_t a = 0; a < 3; ++a) {
        low[a] -= laws.shade_depth;
        high[a] += a < 2 ? laws.shade_depth : 0;
        grid.size_[a] = high[a] - low[a] + 1;
        count *= static_cast<double>(grid.size_[a]);
    }
    if (!(count <= kMaxLightCells))
        return fail(
            Fault::User,
            fmt::format("the tree spreads over {:.3g} cells of {:g}, and {:.3g} are allowed: "
                        "give a larger cell",
                        count, laws.cell, kMaxLightCells));
    grid.low_ = low;
    grid.shade_.resize(static_cast<std::size_t>(count));
    grid.add_up(cells, laws);
    return grid;
}

void LightGrid::add_up(std::vector<Cell> const& cells, Laws const& laws)
{
    std::vector<double> weights;
    for (int k = 0; k <= laws.shade_depth; ++k)
        weights.push_back(laws.shade * std::pow(laws.shade_fall, -k));
    auto const depth = static_cast<std::int64_t>(laws.shade_depth);
    auto const layers = static_cast<std::size_t>(size_[2]);
    auto const grain = layers / static_cast<std::size_t>(2 * thread_count()) + 1;
    parallel_for(layers, grain, [&](std::size_t begin, std::size_t end) {
        auto const from = static_cast<std::int64_t>(begin);
        auto const to = static_cast<std::int64_t>(end);
        for (auto const& cell : cells) {
            auto const i = cell[0] - low_[0];
            auto const j = cell[1] - low_[1];
            auto const top = cell[2] - low_[2];
            for (auto k = std::max(top - depth, from); k <= top && k < to; ++k) {
                auto const reach = top - k;
                double const weight = weights[static_cast<std::size_t>(reach)];
                for (auto row = j - reach; row <= j + reach; ++row) {
                    auto* const first = shade_.data() + (k * size_[1] + row) * size_[0] + i - reach;
                    for (std::int64_t n = 0; n <= 2 * reach; ++n)
                        first[n] += weight;
                }
            }
        }
    });
}

} // namespace tractus::self_organising
