#pragma once

#include "engine/mesh/mesh.h"

#include <optional>

namespace tractus::mesh {

// Returns a simplified prototype of a thin organ for distant views. It is a rhombus from the
// organ's base to its tip, whose width along x gives it the area of the prototype. A closed
// prototype (a needle) becomes two crossing rhombi, each with the area of the needle's silhouette
// from the side, about a quarter of its surface. The first four vertices are the base, right, tip
// and left corners of the first rhombus.
//
// The material is that of the prototype. Returns no value for a prototype that does not mainly
// extend along y, as organ shapes do (organ_shape.h) but imported prototypes may not.
std::optional<TriangleMesh> organ_card(TriangleMesh const& prototype);

} // namespace tractus::mesh
