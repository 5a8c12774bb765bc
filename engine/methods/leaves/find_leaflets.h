#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <vector>

namespace tractus::leaf {

// A leaflet of a drawn compound leaf.
struct Leaflet {
    std::size_t outline = 0;           // Index of the stroke that is its closed outline.
    std::vector<std::size_t> veins {}; // Indices of the strokes inside the outline.
    // The outline's axis of symmetry, from its end on the rachis' side to the tip; and a line from
    // there towards the rachis.
    std::vector<Vec3> axis {};
    std::vector<Vec3> stalk {};
};

// The leaflets of a compound leaf, in order of drawing, and the line that bears them.
struct FoundLeaflets {
    std::vector<Leaflet> leaflets {};
    std::size_t rachis = 0;             // Index of the rachis' stroke.
    std::vector<Vec3> rachis_line {};   // The rachis from the petiole's beginning on.
    std::vector<std::size_t> stalks {}; // Indices of other strokes between rachis and leaflets.

    bool empty() const { return leaflets.empty(); }
};

// Finds the leaflets among the strokes of a drawing, which are evenly spaced. Returns no leaflets
// for a simple leaf: a drawing without two closed strokes beside each other of which the smaller
// one has at least a fifth of the other's area. Fails with a user error if there are leaflets and
// no rachis.
Result<FoundLeaflets> find_leaflets(std::vector<std::vector<Vec3>> const& strokes);

} // namespace tractus::leaf
