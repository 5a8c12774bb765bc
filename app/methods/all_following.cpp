#include "app/methods/all_following.h"

#include "app/methods/all_leaves.h"
#include "engine/methods/silhouettes/nearest_style.h"

namespace tractus::methods {

Following edits_that_follow(scene::Scene const& scene, std::vector<scene::Edit> const& step)
{
    Following following { silhouette::styles_that_follow(scene, step) };
    auto all = step;
    all.insert(all.end(), following.edits.begin(), following.edits.end());
    auto const leaves = leaves_that_follow(scene, all);
    following.edits.insert(following.edits.end(), leaves.begin(), leaves.end());
    following.has_leaves = !leaves.empty();
    return following;
}

} // namespace tractus::methods
