#include "engine/methods/self_organising/light.h"

#include "engine/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tractus::self_organising {

Result<Light> compete_for_light(GrowingTree const& tree, std::vector<Bud> const& buds,
                                std::span<Vec3 const> others, Laws const& laws)
{
    std::vector<Vec3> points;
    points.reserve(buds.size() + others.size());
    for (auto const& bud : buds)
        points.push_back(tree.places[bud.node].position);
    points.insert(points.end(), others.begin(), others.end());
    Light light { TRY(LightGrid::make(points, laws)), std::vector<double>(buds.size()) };
    for (std::size_t i = 0; i < buds.size(); ++i) {
        double const shade = light.grid.shade_at(cell_at(points[i], laws.cell));
        bool const is_above_ground = points[i].z() >= laws.ground;
        light.quality[i]
            = is_above_ground ? std::max(laws.full_light - shade + laws.shade, 0.0) : 0;
    }
    return light;
}

Vec3 brightest_direction(LightGrid const& grid, Vec3 const& position, Vec3 const& direction,
                         Laws const& laws)
{
    constexpr double kSame = 1e-12; // Shades that differ by less count as equal.
    double const cosine = std::cos(radians(laws.perception_angle_deg) / 2);
    // A cheap test with a margin for rounding excludes most cells before the exact test.
    double const farthest = laws.perception_radius * laws.perception_radius * (1 + 1e-9);
    double const narrowest = cosine > 0 ? cosine * cosine * (1 - 1e-9) : 0;
    auto const reach = static_cast<std::int64_t>(std::ceil(laws.perception_radius / laws.cell));
    auto const [x, y, z] = cell_at(position, laws.cell);
    auto const offset = [&](std::int64_t number, double from) {
        return (static_cast<double>(number) + 0.5) * laws.cell - from;
    };
    double least = std::numeric_limits<double>::infinity();
    Vec3 best = Vec3::Zero();
    for (auto k = z + reach; k >= z - reach; --k)
        for (auto j = y - reach; j <= y + reach; ++j) {
            double const up = offset(k, position.z());
            double const aside = offset(j, position.y());
            // Squared distance from the bud to the row of cells.
            double const off_row = aside * aside + up * up;
            if (off_row > farthest)
                continue;
            // The row has no cell in the cone if the cone does not even contain the row's direction
            // nearest to the cone's axis, (x, aside, up) with the best x.
            double const beside = std::max(aside * direction.y() + up * direction.z(), 0.0);
            double const lengthwise = direction.x() * direction.x();
            if (cosine > 0 && beside * beside < (narrowest - lengthwise) * off_row)
                continue;
            for (auto i = x - reach; i <= x + reach; ++i) {
                Vec3 const way(offset(i, position.x()), aside, up);
                double const along = dot(way, direction);
                double const squared = dot(way, way);
                if (squared > farthest
                    || (cosine > 0 && (along <= 0 || along * along < squared * narrowest)))
                    continue;
                double const distance = std::sqrt(squared);
                bool const is_perceived = distance > 0 && distance <= laws.perception_radius
                    && along >= distance * cosine;
                if (!is_perceived)
                    continue;
                if (double const shade = grid.shade_at({ i, j, k }); shade < least - kSame) {
                    least = shade;
                    best = way * (1 / distance);
                    if (least <= kSame) // The cell is unshaded; no other can be better.
                        return best;
                }
            }
        }
    return best;
}

} // namespace tractus::self_organising
