#pragma once

#include "engine/methods/silhouettes/arrangement.h"

#include <vector>

namespace tractus::silhouette {

// arrange() for patterns with nodes, such that the branches of one stand there together: nodes are
// as far from each other as node_distance() says of what is above `first_u`, each has as many
// branches as the pattern, and only the last one fewer, where the count does not divide. Where
// drawn branches keep their u, a node is there; others move to a node on whose turn their side is,
// or nearly. Then whole nodes turn, each offered a random turn as arrange() offers places; those
// drawn stay near their side.
//
// There are fewer branches at a node below the last where more that keep their u are there than go
// into all nodes, or stand where none has room.
Arrangement arrange_whorls(std::vector<DrawnPlace> const& drawn, ArrangementOptions const& options,
                           RandomKey const& key);

} // namespace tractus::silhouette
