#pragma once

#include "engine/plant/plant.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::variation {

// How far two plants of one topology lie apart: the root mean square of the distances between nodes
// of the same number, millimetres. Both have the same number of them; 0 for none.
double distance_mm(std::span<Vec3 const> one, std::span<Vec3 const> other);

// Spread of several distances.
struct DistanceSpread {
    std::size_t count = 0;
    double mean_mm = 0;
    double deviation_mm = 0; // Standard deviation; 0 for fewer than two.
};

// How much the plants of a collection differ, from each other and from what was drawn. It looks at
// some 2,000 nodes of each plant, evenly chosen by their numbers, so that many can be compared.
class Diversity {
public:
    // `drawn` is the plant as drawn (at_variability() at 0); all others have its topology.
    explicit Diversity(Plant const& drawn);

    void add(Plant const& plant);

    DistanceSpread between_plants() const; // Every pair. O(plants squared).
    DistanceSpread from_drawn() const;

private:
    std::vector<Vec3> looked_at(Plant const& plant) const;

    std::size_t stride_ = 1;
    std::vector<Vec3> drawn_mm_;
    std::vector<std::vector<Vec3>> plants_mm_;
};

} // namespace tractus::variation
