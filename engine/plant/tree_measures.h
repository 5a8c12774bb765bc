#pragma once

#include "engine/plant/plant.h"

#include <cstddef>

namespace tractus {

// What a forester measures of a standing tree, and a hydrologist of a river net. Millimetres.
struct TreeMeasures {
    std::size_t internodes = 0;
    double height_mm = 0;          // Of the highest node above the plant's base.
    double breast_diameter_mm = 0; // Of the thickest wood at 1.3 m; of the base where none is.
    double slenderness = 0;        // Height by that diameter.
    double crown_width_mm = 0;     // Mean of the spreads along x and y.
    // Height below which one leaf in twenty is, or one branch tip where there are no leaves.
    double crown_base_mm = 0;
    int strahler = 0; // Horton and Strahler's order of the base: 1 for a stem without branches.
    // Horton's ratios: how many times fewer, and longer, the streams of an order are than those of
    // the order below, by regression over the orders. 0 where there are fewer than three orders.
    double bifurcation_ratio = 0;
    double length_ratio = 0;
    // The e for which d^e = sum of d_child^e holds best over all forks (Minamino and Tateno 2014);
    // 0 where there are none.
    double pipe_exponent = 0;
};

// All 0 for a plant without branches.
TreeMeasures measure_tree(Plant const& plant);

} // namespace tractus
