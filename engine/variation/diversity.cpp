#include "engine/variation/diversity.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>

namespace tractus::variation {

static constexpr std::size_t kNodes = 2000;

static DistanceSpread spread_of(std::span<double const> distances_mm)
{
    DistanceSpread spread { .count = distances_mm.size() };
    if (distances_mm.empty())
        return spread;
    auto const count = static_cast<double>(distances_mm.size());
    for (double const distance : distances_mm)
        spread.mean_mm += distance / count;
    if (distances_mm.size() == 1)
        return spread;
    double squares = 0;
    for (double const distance : distances_mm)
        squares += (distance - spread.mean_mm) * (distance - spread.mean_mm);
    spread.deviation_mm = std::sqrt(squares / (count - 1));
    return spread;
}

double distance_mm(std::span<Vec3 const> one, std::span<Vec3 const> other)
{
    CHECK(one.size() == other.size());
    if (one.empty())
        return 0;
    double squares = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        squares += (one[i] - other[i]).squaredNorm();
    return std::sqrt(squares / static_cast<double>(one.size()));
}

Diversity::Diversity(Plant const& drawn)
    : stride_(std::max<std::size_t>(1, drawn.node_position_mm.size() / kNodes))
    , drawn_mm_(looked_at(drawn))
{
}

std::vector<Vec3> Diversity::looked_at(Plant const& plant) const
{
    std::vector<Vec3> nodes;
    for (std::size_t i = 0; i < plant.node_position_mm.size(); i += stride_)
        nodes.push_back(plant.node_position_mm[i]);
    return nodes;
}

void Diversity::add(Plant const& plant)
{
    plants_mm_.push_back(looked_at(plant));
    CHECK(plants_mm_.back().size() == drawn_mm_.size());
}

DistanceSpread Diversity::between_plants() const
{
    std::vector<double> distances_mm;
    for (std::size_t i = 0; i < plants_mm_.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            distances_mm.push_back(distance_mm(plants_mm_[i], plants_mm_[j]));
    return spread_of(distances_mm);
}

DistanceSpread Diversity::from_drawn() const
{
    std::vector<double> distances_mm;
    for (auto const& plant : plants_mm_)
        distances_mm.push_back(distance_mm(plant, drawn_mm_));
    return spread_of(distances_mm);
}

} // namespace tractus::variation
