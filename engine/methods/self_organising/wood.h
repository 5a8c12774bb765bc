#pragma once

#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/habit.h"
#include "engine/methods/self_organising/laws.h"

#include <vector>

namespace tractus::self_organising {

// The power d^e of the diameter d of each node's internode by the pipe model: the sum of d^e over
// the node's children and the branches shed there, or that of a twig if there are none (Shinozaki
// et al. 1964; Minamino and Tateno 2014 for the exponent e).
std::vector<double> pipe_sums(GrowingTree const& tree, Laws const& laws);

// The diameter of each node's internode by the pipe model.
std::vector<double> diameters(GrowingTree const& tree, Laws const& laws);

// The diameter with which each node's internode is drawn: that of the pipe model, and at least that
// of a twig on which the internode's later years have laid rings of Habit::ring_mm. Axes of order 1
// get rings of 0.3 times that width, higher orders none. Internodes that are shorter than the
// habit's, as those of a tree in a small brush stroke are, get narrower rings in proportion. Given
// wood has rings only of the years after it was given. Without the rings young trees are more than
// 100 times as high as thick, and living ones 50 to 80 times. Rings add no weight (sag.h). A node
// is never thinner than its children.
std::vector<double> shown_diameters(GrowingTree const& tree, Habit const& habit);

// Sheds lateral branches that receive less than Laws::shed_below per internode that has grown, with
// all that they bear; branches that consist only of given wood stay. `received` is the light or
// space received at each node of the tree before this step's shoots grew; branches that began in
// this step stay.
void shed_branches(GrowingTree& tree, std::vector<double> const& received, Laws const& laws);

} // namespace tractus::self_organising
