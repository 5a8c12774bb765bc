#pragma once

#include "engine/mesh/make_mesh.h"
#include "engine/plant/plant.h"

#include <cstddef>

namespace tractus::mesh {

// Simplification of a plant for distant views, to a share of its triangles. The remaining parts do
// not move, and the parts of each coarser level are a subset of those of the finer one.
//
// Small twigs are removed first, in random order among twigs of similar size; the remaining twigs
// are thickened so that the total branch volume is preserved. Some organs and polygons are removed,
// too, and the remaining ones enlarged so that their total area is preserved (Cook, Halstead,
// Planck, Ryu 2007, "Stochastic simplification of aggregate detail"). Organs of removed twigs stay
// and are attached to the parent branch. Nodes are removed where this does not visibly change the
// course of a branch. The axis of greatest volume, the trunk, always stays, at its own radius.

// Returns the mesh options for a plant of coarser_plant() with the same `share`: tubes have fewer
// sides and rings, and each section has the area of its circle. For shares of a quarter and less,
// tubes also have open ends and thin organs become cards.
MeshOptions coarser_options(MeshOptions const& options, double share);

// Whether a coarser plant has fewer, enlarged organs of every shape, or all organs of those shapes
// of which it has at most kFewOrgans.
enum class CoarserOrgans { Thin, KeepFew };
constexpr std::size_t kFewOrgans = 200;

// Returns a plant whose mesh with coarser_options() has at most `share` of the triangles of `plant`
// meshed with `options`, and not many fewer. It has more only if the trunk alone has more. `share`:
// above 0, at most 1. `plant` must meet the conditions of make_mesh(). The same arguments always
// give the same plant.
//
// `organs` = KeepFew suits plants that are seen from nearby, where a leaf that is missing in a
// seedling shows. The mesh may then have somewhat more triangles.
Plant coarser_plant(Plant const& plant, MeshOptions const& options, double share,
                    CoarserOrgans organs = CoarserOrgans::Thin);

} // namespace tractus::mesh
