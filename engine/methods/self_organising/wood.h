#pragma once

#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/laws.h"

#include <vector>

namespace tractus::self_organising {

// d^e of each node's internode by the pipe model: the sum over what the node bears and what was
// shed there, or that of a twig where it bears nothing (Shinozaki et al. 1964; Minamino and Tateno
// 2014 for the exponent e).
std::vector<double> pipe_sums(GrowingTree const& tree, Laws const& laws);

// The diameters that follow from the sums.
std::vector<double> diameters(GrowingTree const& tree, Laws const& laws);

// Takes away lateral branches that receive less than Laws::shed_below for each of their internodes,
// with all that they bear. `received` is what nodes received before this step's shoots grew;
// branches younger than that stay.
void shed_branches(GrowingTree& tree, std::vector<double> const& received, Laws const& laws);

} // namespace tractus::self_organising
