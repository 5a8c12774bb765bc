#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <vector>

namespace tractus::methods {

// The edits that a step brings with it, in their order: trees that take the nearest one's style
// follow that (engine/methods/silhouettes/nearest_style.h), and what wears a drawn leaf follows its
// drawing, as leaves_that_follow() says (all_leaves.h).
struct Following {
    std::vector<scene::Edit> edits {};
    bool has_leaves = false; // Leaves are among them.
};
Following edits_that_follow(scene::Scene const& scene, std::vector<scene::Edit> const& step);

} // namespace tractus::methods
