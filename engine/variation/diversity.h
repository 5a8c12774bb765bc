#pragma once

#include "engine/plant/branch_address.h"
#include "engine/plant/plant.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::variation {

// Distance between two plants of the same topology: the root mean square of the distances between
// corresponding nodes. The lists must have the same size; the distance of empty lists is 0.
double distance_mm(std::span<Vec3 const> one, std::span<Vec3 const> other);

// Number, mean and standard deviation of distances between plants (distance_mm()).
struct DistanceSpread {
    std::size_t count = 0;
    double mean_mm = 0;
    double deviation_mm = 0; // Standard deviation; 0 for fewer than two distances.
};

// Measures how much the plants of a collection differ from each other and from the plant as drawn.
// Fewer than 4,000 evenly spaced nodes of the drawn plant are compared with the nodes at the same
// addresses in each other plant, so that many plants can be compared. Where a plant lacks a branch,
// the point at which the branch would begin is compared.
class Diversity {
public:
    // `drawn` is the plant grown with variability 0 (at_variability()).
    explicit Diversity(Plant const& drawn);

    void add(Plant const& plant);

    // Distances between every two of the plants, in O(plants squared).
    DistanceSpread between_plants() const;
    DistanceSpread from_drawn() const;

private:
    // A compared node of the drawn plant: the base or the tip of the segment at an address.
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
