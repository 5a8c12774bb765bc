#pragma once

#include "engine/base/bulk_vector.h"
#include "engine/mesh/extrusion.h"
#include "engine/mesh/spine.h"
#include "engine/mesh/tube.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <span>

namespace tractus::mesh {

// Data to animate a plant in the wind, for one vertex or organ: every axis bends about its base.
// Game engines use different subsets of the data: Unreal's pivot painter uses pivot and axis, the
// foliage of CryEngine and Source uses phase and bend.
struct WindVertex {
    Vec3f pivot_mm = Vec3f::Zero(); // Plant frame: the base of the vertex's axis.
    Vec3f axis = Vec3f::UnitZ();    // Unit vector from the base to the tip of the axis.
    float level = 0;                // Order of the axis: 0 for the trunk.
    float phase = 0; // 0 to below 1; differs between axes, so that branches do not sway in step.
    float bend = 0; // 0 at the base to 1 at the tip, proportional to the arc length along the axis.
};

// Identifies a plant: plants with different keys have different phases.
struct WindKey {
    std::uint64_t seed = 0;
    std::uint32_t plant = 0;
};

// Returns the wind data of a vertex at the base of an axis. A branch has the same phase in every
// level of detail.
WindVertex wind_of(Plant const& plant, Axis const& axis, WindKey const& key);

// Returns the wind data of an organ or polygon, which moves with the end of `segment`. For kNone,
// the ground, it does not move.
WindVertex wind_at(Plant const& plant, SegmentId segment, WindKey const& key);

// Sets `bend` of each vertex that write_tube() or write_extrusion() makes to its relative position
// along the axis. The size of `to` is the number of vertices in the part's extent.
void bend_tube(Spine const& spine, TubePart const& part, std::span<WindVertex> to);
void bend_extrusion(Extrusion const& extrusion, TubePart const& part, std::span<WindVertex> to);

} // namespace tractus::mesh
