#pragma once

#include "engine/methods/leaves/drawn_leaf.h"

#include <span>
#include <vector>

namespace tractus::leaf {

// Widths and lengths of the parts of a compound leaf's rachis in its grammar, in units of the
// longest leaflet's length.
constexpr double kRachisWidths = 2;        // Width of the rachis as a multiple of DrawnLeaf::width.
constexpr double kLeafletKnot = 0.008;     // Length of a knot, on which a leaflet stands.
constexpr double kLeafletStalkEnd = 0.004; // Length of the end of each leaflet's stalk.

// The rachis of a compound leaf.
struct MeasuredRachis {
    std::vector<DrawnLeaf::Leaflet> leaflets {};
    DrawnLeaf::Leaflet end {};
    std::vector<FlatLine> outlines {}; // As in LeafFit::leaflets.
    BladePlace place {}; // The first leaflet's place on the rachis, as LeafFit::place.
};

// Measures the rachis of a drawn compound leaf such that the grammar puts each leaflet's base and
// axis where they were drawn. `places` are the places of the leaflets in the drawing. Of `leaf`,
// the size and the width are used.
MeasuredRachis measure_rachis(RecognisedLeaf const& drawn, std::span<BladePlace const> places,
                              DrawnLeaf const& leaf);

} // namespace tractus::leaf
