#pragma once

#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"

#include <stop_token>

namespace tractus::mesh {

// Resolution and style of a plant's mesh.
struct MeshOptions {
    // Limits on the number of a tube's sides, which is constant along an axis. The thickest axis of
    // the plant has `max_sides`; the number falls with the square root of an axis' radius, down to
    // `min_sides`. Both are 3 to 64; if they are equal, all axes have the same number of sides.
    int min_sides = 5;
    int max_sides = 16;

    // Maximum number of pieces into which a segment is divided where the axis bends, so that
    // branches look curved (a cubic through the nodes). 0 to 16; 0 and 1 keep segments straight.
    int subdivision = 4;

    // How much a lateral axis widens at its base, as a share of its own radius; it stays thinner
    // than its parent. 0: no collar. If axes have different numbers of sides, laterals with only
    // `min_sides` have no collar.
    double collar = 0.45;

    // Whether tubes are closed: tips by domes, and bases without a parent by flat faces. Open ends
    // save a third of the triangles of a plant with short axes, and can be seen only from close by.
    // A tip of radius 0 is a point with both settings.
    enum class Ends { Closed, Open };
    Ends ends = Ends::Closed;

    // How a polygon approximates the circle of a tube's section. OnCircle: its corners are on the
    // circle. SameArea: it is scaled up to the area of the circle, so that the tube has the right
    // volume.
    enum class Sections { OnCircle, SameArea };
    Sections sections = Sections::OnCircle;

    // Cards: a thin organ (of a two-sided material) is replaced by a card (organ_card.h) if the
    // card has fewer triangles; buds and fruits have as few as roughly keep their shape.
    enum class Organs { Full, Cards };
    Organs organs = Organs::Full;

    // By how much the surface of an organ may differ from its exact one, to save triangles. 0: not
    // at all.
    double organ_error_mm = 0;
};

// Returns the triangle mesh of a plant, in the plant's frame. In each surface tubes come first,
// then polygons.
//
// The cross-sections of a tube follow a rotation-minimising frame and stay round through bends: a
// sharp bend gets an elbow of several sections around the node. An axis starts on the centre line
// of its parent; its tip is a dome, or a point if its radius is 0; its base is closed if it has no
// parent. Coincident nodes are merged; axes without length and polygons without area give no
// triangles. `plant` must pass check_plant() and give fewer than 2^32 vertices per material.
//
// Runs on all threads available to oneTBB; the result does not depend on their number.
//
// Returns early if `stop` is requested; the result is then unusable.
Mesh make_mesh(Plant const& plant, MeshOptions const& options = {},
               std::stop_token const& stop = {});

// Returns the transform from an organ's prototype to the plant's frame.
InstanceTransform transform_of(Organ const& organ);

// Returns the mesh of one organ at scale 1, in the organ frame.
TriangleMesh make_prototype(Plant const& plant, OrganShapeId shape,
                            MeshOptions const& options = {});

// Returns only the organs of a plant's mesh: the prototype and all copies of each organ shape that
// the plant uses and that has triangles.
std::vector<InstancedMesh> make_organs(Plant const& plant, MeshOptions const& options = {});

} // namespace tractus::mesh
