#pragma once

#include "engine/plant/plant.h"

namespace tractus {

// Gives a plant's nodes radii so that wood is conserved at every fork, from the tips down:
// r_parent^exponent = sum of r_child^exponent (Leonardo: 2; measured 1.8 to 2.3, Eloy, "Leonardo's
// rule, self-similarity and wind-induced stresses in trees", PRL 107, 2011; Murray: 3).
//
// A tip has `tip_radius_mm`. Children of a segment are the axes that stand on its end and the next
// segment of its own axis; a segment's radius is its base node's. Where an axis ends in a fork, its
// last node has the radius of its last segment. Radii never fall from a tip to the base.
void apply_pipe_model(Plant& plant, double exponent, double tip_radius_mm);

} // namespace tractus
