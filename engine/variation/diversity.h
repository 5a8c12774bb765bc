#pragma once

#include "engine/plant/branch_address.h"
#include "engine/plant/plant.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::variation {

// Distance between two plants of the same topology: the root mean square of the distances between
// corresponding nodes. Both lists have the same size; 0 for empty lists.
double distance_mm(std::span<Vec3 const> one, std::span<Vec3 const> other);

// Number, mean and standard deviation of distances between plants (distance_mm()).
struct DistanceSpread {
    std::size_t count = 0;
    double mean_mm = 0;
    double deviation_mm = 0; // Standard deviation; 0 for fewer than two distances.
};

// Measures how much the plants of a collection differ from each other and from the plant as drawn.
// Compares about 2,000 evenly spaced nodes of the drawn plant, so that many plants can be compared,
// with the nodes at the same addresses of each other plant. Where a plant lacks a branch, the point
// at which that branch would begin is compared.
class Diversity {
public:
    // `drawn` is the plant as drawn (at_variability() at 0).
    explicit Diversity(Plant const& drawn);

    void add(Plant const& plant);

    DistanceSpread between_plants() const; // Over every pair of plants, in O(plants squared).
    DistanceSpread from_drawn() const;

private:
    // A node of the drawn plant, identified as the tip or base of the segment at an address.
    struct Place {
        NodeId node = 0;
        SegmentAddress segment {};
        bool is_base = false;
    };

    std::vector<Vec3> positions_in(Plant const& plant) const;
    bool is_like_drawn(Plant const& plant) const;

    std::vector<Place> places_;
    std::vector<Axis> axes_; // Axes of the drawn plant.
    std::vector<Vec3> drawn_mm_;
    std::vector<std::vector<Vec3>> plants_mm_;
};

} // namespace tractus::variation
