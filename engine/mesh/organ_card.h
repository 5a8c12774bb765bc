#pragma once

#include "engine/mesh/mesh.h"
#include "engine/plant/organ_shape.h"

#include <optional>

namespace tractus::mesh {

// Returns a simplified prototype of a thin organ for distant views. It is a rhombus from the
// organ's base to its tip, whose width along x gives it the area of the prototype. A closed
// prototype (a needle) becomes two crossing rhombi, each with the area of the needle's silhouette
// from the side, about a quarter of its surface. The first four vertices are the base, right, tip
// and left corners of the first rhombus.
//
// The material is that of the prototype. Returns no value for a prototype that does not mainly
// extend along y, as organ shapes do (organ_shape.h) but imported prototypes may not, and for one
// of many separate parts, such as the leaves of a twig, between which light comes through.
std::optional<TriangleMesh> organ_card(TriangleMesh const& prototype);

// Returns a body of six triangles in place of a bud or fruit for distant views: from the
// prototype's lowest place along y to its highest, and in the middle as wide as the prototype's
// box. Its vertices have the texture coordinates of the prototype's nearest ones.
TriangleMesh organ_spindle(TriangleMesh const& prototype);

// Returns a spray (OrganShape::spray) with fewer, larger leaves of the same total area, for distant
// views: a single card would be a large opaque shape where light comes through between the leaves.
OrganShape coarser_spray(OrganShape const& spray);

} // namespace tractus::mesh
