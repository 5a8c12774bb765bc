#pragma once

#include "engine/mesh/mesh.h"

#include <optional>

namespace tractus::mesh {

// A thin organ's prototype as it looks from afar: a rhombus from its base to its tip, across its x,
// as large as the prototype. For a closed prototype (a needle) two that cross, each as large as
// what it shows to a side, about a quarter of its surface. The first four vertices are base, right,
// tip and left of the first rhombus.
//
// Its material is the prototype's. No value for what does not lie along +y as our organs do
// (organ_shape.h), as others' may not.
std::optional<TriangleMesh> organ_card(TriangleMesh const& prototype);

} // namespace tractus::mesh
