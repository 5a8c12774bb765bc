#pragma once

#include "engine/base/bulk_vector.h"
#include "engine/mesh/extrusion.h"
#include "engine/mesh/spine.h"
#include "engine/mesh/tube.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <span>

namespace tractus::mesh {

// Data for one vertex or organ, to animate a plant in the wind, where every axis bends about its
// base. Game engines use different subsets of the data: Unreal's pivot painter uses pivot and axis,
// the foliage of CryEngine and Source uses phase and bend.
struct WindVertex {
    Vec3f pivot_mm = Vec3f::Zero(); // Base of the vertex's axis, plant frame.
    Vec3f axis = Vec3f::UnitZ();    // Unit vector from the base to the tip of the axis.
    float level = 0;                // Order of the axis: 0 for the trunk.
    float phase = 0; // 0 to below 1; differs between axes, so that branches do not sway in step.
    float bend = 0; // 0 at the base to 1 at the tip, proportional to the arc length along the axis.
};

// Identifies a plant. The branches of plants with different keys sway with different phases.
struct WindKey {
    std::uint64_t seed = 0;
    std::uint32_t plant = 0;
};

// Returns the wind data of a vertex at the base of an axis. The phase of a branch is the same in
// every level of detail.
WindVertex wind_of(Plant const& plant, Axis const& axis, WindKey const& key);

// Returns the wind data of an organ or polygon that is attached to the end of `segment`. If
// `segment` is kNone (the ground), the wind does not move it.
WindVertex wind_at(Plant const& plant, SegmentId segment, WindKey const& key);

// Sets `bend` of each vertex that write_tube() or write_extrusion() makes, to the vertex's position
// along the axis, 0 to 1. The size of `to` must be the number of vertices of the part.
void bend_tube(Spine const& spine, TubePart const& part, std::span<WindVertex> to);
void bend_extrusion(Extrusion const& extrusion, TubePart const& part, std::span<WindVertex> to);

} // namespace tractus::mesh
