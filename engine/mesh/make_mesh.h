#pragma once

#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"

#include <stop_token>

namespace tractus::mesh {

// Resolution and style of a plant's mesh.
struct MeshOptions {
    // Number of sides of the tubes, constant along an axis: the thickest axis of the plant has
    // `max_sides`, the others fewer, in proportion to the square root of their radius, but at least
    // `min_sides`. Each 3 to 64; equal values give every axis the same number.
    int min_sides = 5;
    int max_sides = 16;

    // Maximum number of pieces into which a segment is divided where the axis bends, so that
    // branches look curved (a cubic through the nodes). 0 and 1 keep segments straight. 0 to 16.
    int subdivision = 4;

    // How much a lateral axis widens at its base, as a share of its own radius, up to the radius of
    // its parent. 0 for no collar. If axes have different numbers of sides, laterals with only
    // `min_sides` have no collar.
    double collar = 0.45;

    // Whether tubes are closed: tips by domes, and bases without a parent by flat faces. Open ends
    // save a third of the triangles of a plant with short axes and are visible only from close by.
    // A tip of radius 0 is a point in both cases.
    enum class Ends { Closed, Open };
    Ends ends = Ends::Closed;

    // How a tube of few sides approximates a round one. OnCircle: the corners of a section are on
    // the circle. SameArea: it is scaled up to the area of the circle, so that the volume is right.
    enum class Sections { OnCircle, SameArea };
    Sections sections = Sections::OnCircle;

    // Whether thin organs (of two-sided materials) are replaced by cards (organ_card.h), where a
    // card has fewer triangles.
    enum class Organs { Full, Cards };
    Organs organs = Organs::Full;
};

// Returns the triangle mesh of a plant, in the plant's frame. In each surface tubes come first,
// then polygons.
//
// The cross-sections of a tube follow a rotation-minimising frame and stay round through bends: a
// sharp bend gets an elbow of several sections around the node. An axis starts on the centre line
// of its parent; its tip is a dome, or a point if its radius is 0; its base is closed if it has no
// parent. Coincident nodes are merged; parts without length or area give no triangles. `plant` must
// pass check_plant() and give fewer than 2^32 vertices per material.
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

// Returns only the organs: for each shape that is used and has triangles, its prototype and all
// copies.
std::vector<InstancedMesh> make_organs(Plant const& plant, MeshOptions const& options = {});

} // namespace tractus::mesh
