#pragma once

#include "engine/base/result.h"
#include "engine/mesh/closed_mesh.h"
#include "engine/mesh/solid_parts.h"

namespace tractus::mesh {

// Returns all parts united into one closed surface, as far as they touch each other: the boundary
// of the union of branches, plates and closed organs, without what is inside of it. Hollows that
// leaves enclose are filled.
//
// The surface is found on a grid whose cells are 0.4 times the least thickness wide. It is exact to
// a small share of that; sharper edges are rounded. Runs on all threads; the result does not depend
// on their number.
//
// Fails with a user error if the grid would be too large for the plant: the message names a
// thickness with which it is not.
Result<ClosedMesh> closed_shell(SolidParts const& parts);

} // namespace tractus::mesh
