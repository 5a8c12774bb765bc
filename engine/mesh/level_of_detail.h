#pragma once

#include "engine/mesh/make_mesh.h"
#include "engine/plant/plant.h"

namespace tractus::mesh {

// Simplification of a plant for distant views, to a share of its triangles. Nothing changes its
// position: the remaining parts stay in place, and each coarser level is a subset of the finer one.
//
// Small twigs are removed first, in random order among twigs of similar size; the remaining ones
// are thickened so that the total branch volume is preserved. Organs and polygons are thinned out,
// and the remaining ones enlarged so that the total area is preserved (Cook, Halstead, Planck, Ryu
// 2007, "Stochastic simplification of aggregate detail"). Organs of removed twigs stay and are
// attached to the parent branch. Nodes whose removal does not visibly change the course of a branch
// are removed, too. The axis of greatest volume, the trunk, always stays, at its own radius.

// Returns the mesh options for a plant of coarser_plant(): tubes with fewer sides and rings, each
// section with the area of its circle; for shares of a quarter and less, also open ends and organs
// as cards. `share` as for coarser_plant().
MeshOptions coarser_options(MeshOptions const& options, double share);

// Returns a plant whose mesh with coarser_options() has at most `share` of the triangles of `plant`
// meshed with `options`, and not many fewer. The limit is exceeded only if the trunk alone does so.
// `share`: above 0, at most 1. `plant` as for make_mesh(). Deterministic.
Plant coarser_plant(Plant const& plant, MeshOptions const& options, double share);

} // namespace tractus::mesh
