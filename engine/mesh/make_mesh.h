#pragma once

#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"

#include <stop_token>

namespace tractus::mesh {

// How fine a plant's triangles are.
struct MeshOptions {
    // Sides of the tubes. An axis has the same number from base to tip: the plant's thickest axis
    // has `max_sides`, the others fewer with the square root of their radius. 3 to 64 each; equal
    // values give every axis the same.
    int min_sides = 5;
    int max_sides = 16;

    // Into how many pieces a segment may be cut where the axis bends, so that branches look
    // curved: a cubic through the nodes. 0 and 1 keep the segments straight. 0 to 16.
    int subdivision = 4;

    // How far a lateral axis flares where it leaves its parent, as a share of its own radius; the
    // parent's radius is never exceeded. 0 for no collar. The thinnest axes (those with
    // `min_sides`) have none.
    double collar = 0.45;

    // Whether tubes are closed: tips by domes, bases that stand on nothing by flat faces. Open ends
    // save a third of the triangles of a plant of short axes, and are seen from near by only. A tip
    // without radius is a point in both cases.
    enum class Ends { Closed, Open };
    Ends ends = Ends::Closed;

    // How a tube of few sides stands for a round one: with its corners on the circle, or wider, so
    // that its sections have the circle's area and the tube its volume.
    enum class Sections { OnCircle, SameArea };
    Sections sections = Sections::OnCircle;

    // Whether thin organs (of materials that are seen from both sides) are made as cards where that
    // takes fewer triangles (organ_card.h).
    enum class Organs { Full, Cards };
    Organs organs = Organs::Full;
};

// The plant as triangles, in the plant's frame. Tubes come first in each surface, then polygons.
//
// A tube's cross-sections follow a rotation-minimising frame and stay round through bends: a sharp
// one gets an elbow of several sections around the node. An axis starts on its parent's centre
// line, ends in a dome, or in a point where its radius is zero, and is closed at the base where it
// stands on nothing. Nodes that coincide count as one; what has no length or no area makes no
// triangles. `plant` must pass check_plant() and have fewer than 2^32 vertices to be made per
// material.
//
// Runs on all threads that oneTBB may use; the result is the same for any number of them.
//
// Ends early when `stop` asks for it; what comes out then is good for nothing.
Mesh make_mesh(Plant const& plant, MeshOptions const& options = {},
               std::stop_token const& stop = {});

// Where an organ's prototype stands.
InstanceTransform transform_of(Organ const& organ);

// One organ of scale 1, in its own frame.
TriangleMesh make_prototype(Plant const& plant, OrganShapeId shape,
                            MeshOptions const& options = {});

// The organs alone: one prototype for each shape that has triangles and is used, and its copies.
std::vector<InstancedMesh> make_organs(Plant const& plant, MeshOptions const& options = {});

} // namespace tractus::mesh
