#pragma once

#include "engine/mesh/mesh.h"

#include <optional>

namespace tractus::mesh {

// Returns a simplified prototype of a thin organ for distant views: a rhombus from its base to its
// tip, across its x axis, with the area of the prototype. A closed prototype (a needle) becomes two
// crossing rhombi, each with the area of its silhouette from the side, about a quarter of its
// surface. The first four vertices are the base, right, tip and left corners of the first rhombus.
//
// The material is that of the prototype. Returns no value for a prototype that does not extend
// along +y as organ shapes do (organ_shape.h), which imported prototypes may not.
std::optional<TriangleMesh> organ_card(TriangleMesh const& prototype);

} // namespace tractus::mesh
