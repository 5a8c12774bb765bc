#pragma once

#include "engine/plant/plant.h"

namespace tractus {

// Sets the radii of a plant's nodes by the pipe model, from the tips down: r_parent^exponent = sum
// of r_child^exponent. Exponents: Leonardo 2; measured 1.8 to 2.3 (Eloy, "Leonardo's rule,
// self-similarity and wind-induced stresses in trees", PRL 107, 2011); Murray 3.
//
// A tip has `tip_radius_mm`. The children of a segment are the axes attached to its end and the
// next segment of its own axis; the radius of a segment is that of its base node. If an axis ends
// in a fork, its last node has the radius of its last segment. Radii never decrease from tip to
// base.
void apply_pipe_model(Plant& plant, double exponent, double tip_radius_mm);

} // namespace tractus
