#pragma once

#include "engine/methods/self_organising/growing_tree.h"

#include <vector>

namespace tractus::self_organising {

// What branches weigh and how stiff they are. Lengths in millimetres.
struct SagLaws {
    double weight = 1;              // Multiplies gravity; 0: nothing sags.
    double density_kg_per_m3 = 900; // Of green wood.
    double stiffness_gpa = 6;       // Young's modulus of green wood along the grain.
    double leaf_kg = 0.001;         // Weight of the leaves of one internode,
    int leaf_years = 1;             // which it bears so many years.
};

// Bends each internode, as an elastic rod (Euler and Bernoulli), by the moment that has come upon
// it since it was bent last, with the width that it has now: wood that grew later has set the
// earlier bend. The tree keeps its lengths; buds turn with what bears them. `diameters` as
// diameters() has them.
void sag(GrowingTree& tree, std::vector<double> const& diameters, SagLaws const& laws);

// Takes the bend that the tree has as set by what it carries now: for wood that grew where a brush
// led it.
void set_wood(GrowingTree& tree, std::vector<double> const& diameters, SagLaws const& laws);

} // namespace tractus::self_organising
