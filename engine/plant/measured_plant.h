#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus {

// One node of a plant that was measured, or written by another program, with what bears it.
struct MeasuredNode {
    std::uint32_t below = kNone; // The node that it stands on, one before it; kNone: the ground.
    bool continues = false;      // The axis of `below` goes on here; otherwise a lateral begins.
    Vec3 position_mm = Vec3::Zero(); // Plant frame, anywhere.
    std::optional<double> radius_mm {};
    // Radius of the segment that ends here, where it begins. Counts at the base of an axis only.
    std::optional<double> base_radius_mm {};
};

// A plant of such nodes: a segment from each node to the one below. The base of the first goes to
// the origin. If no node has a radius, radii follow from the pipe model, with tips of 0.2 % of the
// height; otherwise a node without one has that of what is below it, and a lateral begins as thick
// as it is at its first node, unless it says otherwise.
//
// Refuses, in a sentence that begins with `name`, numbers that are not finite, radii below 0, nodes
// without a single segment that has a length, and what check_size() does.
Result<Plant> plant_from_nodes(std::string const& name, std::span<MeasuredNode const> nodes);

// Such a plant, and where its nodes went.
struct MeasuredPlant {
    Plant plant {};
    std::vector<SegmentId> segments {}; // The one that ends at each node; kNone: none does.
    Vec3 base_mm = Vec3::Zero();        // The node that went to the origin.
};
Result<MeasuredPlant> measured_plant_from_nodes(std::string const& name,
                                                std::span<MeasuredNode const> nodes);

// Lengths in such files are metres where the whole is smaller than 100 units, else millimetres:
// what they are to be multiplied with.
double millimetres_per_unit(Bounds const& units);

// Refuses, in a sentence that begins with `name`, a plant that no plant can be: more than 10 km
// large, or more than a million km away from where its file has its origin.
Result<void> check_size(std::string const& name, Bounds const& box_mm);

} // namespace tractus
