#pragma once

#include "engine/plant/plant.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::variation {

// Distance between two plants of the same topology: the root mean square of the distances between
// corresponding nodes. Both lists have the same size; 0 for empty ones.
double distance_mm(std::span<Vec3 const> one, std::span<Vec3 const> other);

// Statistics of several distances.
struct DistanceSpread {
    std::size_t count = 0;
    double mean_mm = 0;
    double deviation_mm = 0; // Standard deviation; 0 for fewer than two.
};

// Measures how much the plants of a collection differ from each other and from the plant as drawn.
// Uses about 2,000 evenly spaced nodes of each plant, so that many plants can be compared.
class Diversity {
public:
    // `drawn` is the plant as drawn (at_variability() at 0); all others must have its topology.
    explicit Diversity(Plant const& drawn);

    void add(Plant const& plant);

    DistanceSpread between_plants() const; // Over every pair of plants, in O(plants squared).
    DistanceSpread from_drawn() const;

private:
    std::vector<Vec3> looked_at(Plant const& plant) const;

    std::size_t stride_ = 1;
    std::vector<Vec3> drawn_mm_;
    std::vector<std::vector<Vec3>> plants_mm_;
};

} // namespace tractus::variation
