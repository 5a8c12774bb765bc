#include "engine/methods/silhouettes/bump_leaf.h"

#include "engine/methods/silhouettes/bump_touch.h"

namespace tractus::silhouette {

// Index of the branch that ends in a bump. The system's first branches end in the lateral bumps, in
// the order of the bumps.
static std::optional<std::size_t> branch_of_bump(BranchingSystem const& system, std::size_t bump)
{
    if (system.bumps[bump].role != Role::Lateral || system.is_in_siblings_style)
        return std::nullopt;
    std::size_t branch = 0;
    for (std::size_t i = 0; i < bump; ++i)
        branch += system.bumps[i].role == Role::Lateral;
    return branch < system.branches.size() ? std::optional(branch) : std::nullopt;
}

std::optional<BumpLeaf> leaf_on_bump(Skeleton const& skeleton, Vec2 const& place, Search search)
{
    // Maximum distance of the touch from the branch's part of the crown, as a share of the
    // outline's diagonal.
    constexpr double kNear = 0.04;
    for (auto const s : outlined_systems(skeleton, search)) {
        auto const& system = skeleton.systems[s];
        auto const bump = touched_bump(system.bumps, system.outline,
                                       { .kind = BumpTouch::Kind::Split, .place = place });
        if (!bump)
            continue;
        auto const i = branch_of_bump(system, *bump);
        if (!i)
            return std::nullopt;
        auto const& crown = system.branches[*i].crown;
        double const near = kNear * box_of(system.outline).diagonal();
        if (!is_inside(crown, place) && distance_to_outline(crown, place) > near)
            return std::nullopt;
        return BumpLeaf { skeleton.path_of({ s, *i }), crown };
    }
    return std::nullopt;
}

} // namespace tractus::silhouette
