#include "engine/methods/silhouettes/own_branch.h"

#include <algorithm>
#include <utility>

namespace tractus::silhouette {

namespace {

// A point on a branch is at most this far from the branch's axis, as a share of the outline's
// diagonal.
constexpr double kNear = 0.025;
// A point on a branch is at least this far from the trunk, as a share of the outline's diagonal.
constexpr double kOffTrunk = 0.02;
// Minimum length of a stroke for a branch, as a share of the parent branch's length.
constexpr double kShortest = 0.02;

bool is_long_enough(std::span<Vec2 const> stroke, Branch const& parent)
{
    return length_of(stroke) >= kShortest * parent.path.length;
}

} // namespace

std::optional<NearestBranch> branch_near(BranchingSystem const& system, Vec2 const& place)
{
    double const diagonal = box_of(system.outline).diagonal();
    double const to_trunk = distance_to_line(place, system.whole_trunk());
    if (to_trunk < kOffTrunk * diagonal)
        return std::nullopt;
    std::optional<NearestBranch> nearest;
    double least = std::min(to_trunk, kNear * diagonal);
    for (std::size_t i = 0; i < system.branches.size(); ++i) {
        auto const& branch = system.branches[i];
        if (branch.origin == Branch::Origin::Apex)
            continue;
        double const far = distance_to_line(place, branch.line(17));
        if (far >= least)
            continue;
        least = far;
        nearest = { i, far };
    }
    return nearest;
}

std::optional<BranchRef> branch_near(Skeleton const& skeleton, Vec2 const& place)
{
    std::optional<BranchRef> nearest;
    double least = 1e300;
    for (auto const s : skeleton.drawn_systems()) {
        auto const near = branch_near(skeleton.systems[s], place);
        if (!near || near->distance >= least)
            continue;
        least = near->distance;
        nearest = { s, near->branch };
    }
    return nearest;
}

std::optional<std::size_t> parent_of(BranchingSystem const& system, std::span<Vec2 const> stroke)
{
    if (stroke.size() < 2 || is_closed_stroke(stroke))
        return std::nullopt;
    auto const near = branch_near(system, stroke.front());
    if (!near || !is_long_enough(stroke, system.branches[near->branch]))
        return std::nullopt;
    return near->branch;
}

void take_own_branches(BranchingSystem& system, std::span<OwnBranch const> branches)
{
    for (auto const& own : branches) {
        auto const parent = number_of(system, own.branch);
        if (!parent)
            continue;
        auto& branch = system.branches[*parent];
        branch.own_branches.push_back(own.line);
        branch.model.reset();
        branch.from_model = {};
        if (own.style_to != StyleScope::None)
            branch.style_to = own.style_to;
    }
}

Result<std::optional<std::string>> parent_of_drawn_branch(Drawing const& drawing,
                                                          std::span<Vec2 const> stroke,
                                                          SkeletonOptions const& options,
                                                          Search search)
{
    if (search == Search::OnTrunk || !drawing.is_refined()) {
        auto const system = TRY(infer_on_trunk(drawing, options));
        auto const parent = parent_of(system, stroke);
        return parent ? std::optional(name_of(system.branches[*parent])) : std::nullopt;
    }
    if (stroke.size() < 2 || is_closed_stroke(stroke))
        return std::nullopt;
    auto const skeleton = TRY(infer_skeleton(drawing, options));
    auto const parent = branch_near(skeleton, stroke.front());
    if (!parent
        || !is_long_enough(stroke, skeleton.systems[parent->system].branches[parent->branch]))
        return std::nullopt;
    return skeleton.path_of(*parent);
}

Result<void> add_own_branch(Drawing& drawing, std::vector<Vec2> stroke, StyleScope style_to,
                            SkeletonOptions const& options, Search search)
{
    auto const parent = TRY(parent_of_drawn_branch(drawing, stroke, options, search));
    if (!parent)
        return fail(Fault::User,
                    "the line begins on none of the tree's branches: draw it from one on, not "
                    "from the trunk");
    drawing.own_branches.push_back({ *parent, std::move(stroke), style_to });
    return {};
}

} // namespace tractus::silhouette
