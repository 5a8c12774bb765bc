#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus {

// One node of a plant that was measured or imported from another program, with its parent node.
struct MeasuredNode {
    // Index of the parent node, which must come earlier in the list; kNone: on the ground.
    std::uint32_t below = kNone;
    // True: this node continues the axis of `below`. False: a lateral axis begins at `below`.
    bool continues = false;
    Vec3 position_mm = Vec3::Zero(); // Plant frame; the origin is arbitrary.
    std::optional<double> radius_mm {};
    // Radius at the lower end of the segment that ends at this node. Used only at the base of an
    // axis.
    std::optional<double> base_radius_mm {};
};

// Builds a plant with a segment from each node to its parent node. The plant is translated so that
// the first base is at the origin. If no node has a radius, the radii follow from the pipe model,
// with a tip radius of 0.2 % of the plant's height. Otherwise a node without a radius has that of
// its parent, and a lateral begins with the radius of its first node, unless `base_radius_mm` is
// given.
//
// Fails, in a sentence that begins with `name`, if a number is not finite, a radius is negative, no
// segment has a length, or check_size() fails.
Result<Plant> plant_from_nodes(std::string const& name, std::span<MeasuredNode const> nodes);

// A plant built from measured nodes, and which of its segments ends at which node.
struct MeasuredPlant {
    Plant plant {};
    std::vector<SegmentId> segments {}; // Segment that ends at each measured node, or kNone.
    Vec3 base_mm = Vec3::Zero(); // Original position of the node that was moved to the origin.
};
Result<MeasuredPlant> measured_plant_from_nodes(std::string const& name,
                                                std::span<MeasuredNode const> nodes);

// Guesses the unit of a file from its extent. Returns 1000 (the unit is metres) if the extent is
// smaller than 100 units, otherwise 1 (millimetres).
double millimetres_per_unit(Bounds const& units);

// Fails, in a sentence that begins with `name`, if the plant is implausible: larger than 10 km, or
// more than a million km from the file's origin.
Result<void> check_size(std::string const& name, Bounds const& box_mm);

} // namespace tractus
