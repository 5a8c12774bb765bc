#pragma once

#include "engine/methods/self_organising/growing_tree.h"

#include <vector>

namespace tractus::self_organising {

// Weight and stiffness of branches. Lengths are in millimetres.
struct SagLaws {
    double weight = 1;              // Factor on gravity; 0: branches do not sag.
    double density_kg_per_m3 = 900; // Density of green wood.
    double stiffness_gpa = 6;       // Young's modulus of green wood along the grain.
    double leaf_kg = 0.001;         // Mass of the leaves of one internode.
    int leaf_years = 1;             // Number of years for which an internode bears leaves.
};

// Bends each internode of a branch as an elastic rod (Euler-Bernoulli) by the moment added since it
// was last bent, at its present diameter: wood that grew since then has fixed the earlier bend. The
// trunk does not bend. Internodes keep their lengths; buds turn with the wood that bears them.
// `diameters` come from diameters().
void sag(GrowingTree& tree, std::vector<double> const& diameters, SagLaws const& laws);

// Makes the tree's present shape its rest shape under its present load, for wood that grew along a
// brush or that was bent by strokes.
void set_wood(GrowingTree& tree, std::vector<double> const& diameters, SagLaws const& laws);

} // namespace tractus::self_organising
