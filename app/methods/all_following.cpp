#include "app/methods/all_following.h"

#include "app/methods/all_leaves.h"
#include "engine/methods/silhouettes/nearest_style.h"

namespace tractus::methods {

Following dependent_edits(scene::Scene const& scene, std::vector<scene::Edit> const& step)
{
    Following following { silhouette::dependent_style_edits(scene, step) };
    auto all = step;
    all.insert(all.end(), following.edits.begin(), following.edits.end());
    auto const leaves = dependent_leaf_edits(scene, all);
    following.edits.insert(following.edits.end(), leaves.begin(), leaves.end());
    following.has_leaves = !leaves.empty();
    return following;
}

} // namespace tractus::methods
