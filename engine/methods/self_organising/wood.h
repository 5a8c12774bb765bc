#pragma once

#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/laws.h"

#include <vector>

namespace tractus::self_organising {

// The sum d^e of each node's internode by the pipe model: over the node's children and the branches
// shed there, or the value of a twig if there are none (Shinozaki et al. 1964; Minamino and Tateno
// 2014 for the exponent e).
std::vector<double> pipe_sums(GrowingTree const& tree, Laws const& laws);

// The diameter of each node's internode by the pipe model.
std::vector<double> diameters(GrowingTree const& tree, Laws const& laws);

// Sheds lateral branches that receive less than Laws::shed_below per internode that has grown, with
// all that they bear; given wood without growth stays. `received` is the light or space of each
// node before this step's shoots grew; branches that are younger stay.
void shed_branches(GrowingTree& tree, std::vector<double> const& received, Laws const& laws);

} // namespace tractus::self_organising
