#pragma once

#include "engine/methods/silhouettes/arrangement.h"

#include <vector>

namespace tractus::silhouette {

// Arranges branches like arrange(), for patterns with nodes, keeping the branches of a node
// together. Nodes are spaced by node_distance() over the part above `first_u`. Each node has as
// many branches as the pattern requires; only the last has fewer if the count does not divide
// evenly. A drawn branch that keeps its u defines a node there; the others move to a node with a
// free azimuth at or near their side. Then whole nodes are rotated by the same random search as in
// arrange(); drawn branches stay near their side.
//
// Branches that keep their u can make more nodes necessary than the count requires; nodes below the
// last have fewer branches then.
Arrangement arrange_whorls(std::vector<DrawnPlace> const& drawn, ArrangementOptions const& options,
                           RandomKey const& key);

} // namespace tractus::silhouette
