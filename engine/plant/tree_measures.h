#pragma once

#include "engine/plant/plant.h"

#include <cstddef>

namespace tractus {

// Forest mensuration of a tree, and the stream-order measures that hydrologists use for river
// networks.
struct TreeMeasures {
    std::size_t internodes = 0;
    double height_mm = 0; // Height of the highest node above the plant's base.
    // Diameter of the thickest axis at 1.3 m above the base; diameter of the base if the plant is
    // lower than that.
    double breast_diameter_mm = 0;
    double slenderness = 0;    // Height divided by breast_diameter_mm.
    double crown_width_mm = 0; // Mean of the plant's extents along x and y.
    // Height below which 5 % of the organs are, or of the branch tips if there are no organs.
    double crown_base_mm = 0;
    int strahler = 0; // Horton-Strahler order of the base: 1 for a stem without branches.
    // Horton's ratios between consecutive stream orders, by regression: the factor by which the
    // number of streams decreases (bifurcation), and the factor by which their mean length
    // increases. 0 if the regression has fewer than three orders.
    double bifurcation_ratio = 0;
    double length_ratio = 0;
    // Exponent e with which the diameters d at all forks fit d^e = sum of d_child^e best (Minamino
    // and Tateno 2014); 0 if there are no forks.
    double pipe_exponent = 0;
};

// All measures are 0 for a plant without branches.
TreeMeasures measure_tree(Plant const& plant);

} // namespace tractus
