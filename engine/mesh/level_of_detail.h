#pragma once

#include "engine/mesh/make_mesh.h"
#include "engine/plant/plant.h"

namespace tractus::mesh {

// A plant for being seen from afar, with a share of its triangles. Nothing moves: what is left
// stands where it stood, and from one level to the next only less is left.
//
// Small twigs go first, by chance among twigs of about one size, and those that stay become thicker
// so that the branches keep their volume; organs and polygons are thinned out, and those that stay
// become larger so that they keep their area (Cook, Halstead, Planck, Ryu 2007, "Stochastic
// simplification of aggregate detail"). Organs of twigs that went stay, and ride on the branch that
// bore the twig. Nodes without which a branch runs as before, but for what cannot be seen from so
// far, go too. The thickest axis, the trunk, always stays, as thick as it is.

// How such a plant is meshed: tubes with fewer sides and rings, each of the area of its circle;
// from a quarter of the triangles on, open ends and organs as cards. `share` as below.
MeshOptions coarser_options(MeshOptions const& options, double share);

// The plant of which coarser_options() makes at most `share` of the triangles that `options` make
// of `plant`, and not many less; more only where the trunk alone has more. `share`: above 0, at
// most 1. `plant` as for make_mesh(). The same arguments give the same plant.
Plant coarser_plant(Plant const& plant, MeshOptions const& options, double share);

} // namespace tractus::mesh
