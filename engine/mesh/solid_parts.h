#pragma once

#include "engine/mesh/closed_mesh.h"
#include "engine/mesh/make_mesh.h"
#include "engine/mesh/sheet_pieces.h"

#include <optional>
#include <vector>

namespace tractus::mesh {

struct SolidOptions {
    // Factor on all lengths of the plant, above 0: what is printed is seldom as large as the plant.
    double scale = 1;
    // Thickness of the result, above 0. Thinner branches are thickened; leaves and other sheets
    // become plates.
    double least_thickness_mm = 0.8;
    // Whether leaves, flowers, fruits and filled polygons are part of the solid.
    enum class Organs { Solid, LeftOut };
    Organs organs = Organs::Solid;
};

// An organ shape, polygon or surface: its pieces and the places of all its copies.
struct SolidShape {
    std::vector<SheetPiece> pieces;
    std::vector<InstanceTransform> instances;
    MaterialId material = 0;
};

// The parts of a plant or a mesh before they are made solid.
struct SolidParts {
    // The plant with branches of at least the options' thickness; no value for a mesh, whose
    // branches are shapes. Axes with contours are shapes, too.
    std::optional<Plant> plant {};
    std::vector<SolidShape> shapes {};
    double least_thickness_mm = 0;
};

// Prepares a plant; it must meet the conditions of make_mesh().
SolidParts solid_parts(Plant const& plant, SolidOptions const& options);

// Prepares a mesh. All its open surfaces become plates, also tubes with open ends.
SolidParts solid_parts(Mesh const& mesh, SolidOptions const& options);

// Returns every axis, leaf and polygon as a closed surface of its own. They overlap where branches
// and leaves are attached; slicers unite them. Runs on all threads; the result does not depend on
// their number.
ClosedMesh closed_surfaces(SolidParts const& parts);

} // namespace tractus::mesh
