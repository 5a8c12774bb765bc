#pragma once

#include "engine/methods/silhouettes/outlined_tree.h"

#include <span>
#include <string_view>

namespace tractus::silhouette {

// What to begin with: how the branches of a kind of tree stand, and what its twigs bear. Whatever
// the outline is, it gives the tree that look.
struct ReadyForm {
    std::string_view name; // In logs and on the command line: never changes.
    TreeForm form {};
};

// Oak, pine, willow, eucalyptus, fir, poplar, fern.
std::span<ReadyForm const> ready_forms();

} // namespace tractus::silhouette
