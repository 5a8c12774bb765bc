#pragma once

#include "engine/base/bulk_vector.h"
#include "engine/mesh/extrusion.h"
#include "engine/mesh/spine.h"
#include "engine/mesh/tube.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <span>

namespace tractus::mesh {

// Data to bend a plant in the wind, for one vertex or one organ: every axis turns about its base.
// Engines differ in what they want of it and where; this is what all of them can be given (Unreal's
// pivot painter has pivot and axis, CryEngine's and Source's foliage phase and bend).
struct WindVertex {
    Vec3f pivot_mm = Vec3f::Zero(); // Plant frame: the base of the axis that it belongs to.
    Vec3f axis = Vec3f::UnitZ();    // Unit length: from there to the axis' tip.
    float level = 0;                // The axis' order: 0 for the trunk.
    float phase = 0;                // [0, 1): the axis' own, so that branches do not sway as one.
    float bend = 0; // 0 at the base to 1 at the tip, with the length along the axis.
};

// Names a plant: axes of plants with other keys have other phases.
struct WindKey {
    std::uint64_t seed = 0;
    std::uint32_t plant = 0;
};

// Returns the data of any vertex at the base of an axis. A branch keeps its phase in every level of
// detail.
WindVertex wind_of(Plant const& plant, Axis const& axis, WindKey const& key);

// Returns the data of an organ or a polygon: it moves with the place where its segment ends.
// Nothing moves on the ground.
WindVertex wind_at(Plant const& plant, SegmentId segment, WindKey const& key);

// How far along its axis each vertex is that write_tube() or write_extrusion() makes, as `bend`.
// `to` has as many elements as the extent has vertices.
void bend_tube(Spine const& spine, TubePart const& part, std::span<WindVertex> to);
void bend_extrusion(Extrusion const& extrusion, TubePart const& part, std::span<WindVertex> to);

} // namespace tractus::mesh
