#include "engine/methods/silhouettes/chosen_style.h"

#include "engine/methods/silhouettes/own_branch.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace tractus::silhouette {

namespace {

std::ptrdiff_t level_of(std::string const& path)
{
    return std::count(path.begin(), path.end(), kPathSeparator);
}

Result<void> check_target(std::string const& path, Skeleton const& skeleton)
{
    auto const at = skeleton.at(path);
    if (!at)
        return fail(Fault::User, fmt::format("the tree has no branch {}", path));
    if (!skeleton.systems[at->system].branches[at->branch].own_branches.empty())
        return fail(Fault::User,
                    fmt::format("branches were drawn on branch {}: it keeps them, and takes no "
                                "other one's style",
                                path));
    if (skeleton.systems[at->system].branches[at->branch].is_drawn_leaf())
        return fail(Fault::User,
                    fmt::format("branch {} is a leaf as it was drawn: it takes no other one's "
                                "style",
                                path));
    return {};
}

Result<void> check_source(std::string const& path, std::string const& target,
                          Skeleton const& skeleton)
{
    auto const at = skeleton.at(path);
    if (!at)
        return fail(Fault::User, fmt::format("the tree has no branch {}", path));
    if (skeleton.system_of[at->system][at->branch] == kNoSystem
        && !skeleton.systems[at->system].branches[at->branch].leaf)
        return fail(Fault::User,
                    fmt::format("branch {} bears no branches: it has no style for others", path));
    if (level_of(path) > level_of(target))
        return fail(Fault::User,
                    fmt::format("branch {} is on a deeper level than {}: carry its style to "
                                "branches of its own level",
                                path, target));
    return {};
}

bool runs_over(std::span<Vec2 const> stroke, Branch const& branch, double near)
{
    auto const line = branch.line(17);
    return std::any_of(stroke.begin(), stroke.end(),
                       [&](Vec2 const& point) { return distance_to_line(point, line) <= near; });
}

} // namespace

std::set<std::string> paths_in(ChosenStyles const& styles)
{
    std::set<std::string> paths;
    for (auto const& [target, source] : styles) {
        paths.insert(target);
        if (!source.empty())
            paths.insert(source);
    }
    return paths;
}

std::string source_of(ChosenStyles const& styles, std::string branch)
{
    // Edits cannot create cycles, but a manipulated file can; the bounded loop ends even then.
    for (std::size_t i = 0; i <= styles.size(); ++i) {
        auto const found = styles.find(branch);
        if (found == styles.end())
            break;
        branch = found->second;
    }
    return branch;
}

Result<void> choose_styles(ChosenStyles& styles, ChosenStyles const& chosen,
                           Skeleton const& skeleton)
{
    if (chosen.empty())
        return fail(Fault::User, "no branch is chosen that takes a style");
    auto const before = styles;
    for (auto const& [target, source] : chosen) {
        if (source.empty()) {
            if (styles.erase(target) == 0)
                return fail(Fault::User,
                            fmt::format("branch {} has no other one's style: draw the line from it "
                                        "over those that take its own",
                                        target));
            continue;
        }
        TRY(check_target(target, skeleton));
        TRY(check_source(source, target, skeleton));
        auto from = source_of(before, source);
        if (from != target)
            styles[target] = std::move(from);
    }
    return {};
}

Result<ChosenStyles> copied_by(Skeleton const& skeleton, std::span<Vec2 const> stroke)
{
    // Maximum distance of a stroke from a branch that it crosses, as a share of the outline's
    // diagonal.
    constexpr double kOver = 0.01;
    constexpr std::size_t kPlaces = 400;
    auto const source = branch_near(skeleton, stroke.front());
    if (!source)
        return fail(Fault::User,
                    "the line begins on none of the tree's branches: draw it from the branch whose "
                    "style it carries over those that take it");
    auto const path = skeleton.path_of(*source);
    auto const places = resampled_line(stroke, kPlaces);
    double const near = kOver * box_of(skeleton.systems[0].outline).diagonal();
    ChosenStyles styles;
    for (auto const s : skeleton.drawn_systems())
        for (std::size_t b = 0; b < skeleton.systems[s].branches.size(); ++b) {
            auto const& branch = skeleton.systems[s].branches[b];
            auto target = skeleton.path_of({ s, b });
            if (target == path || level_of(target) != level_of(path)
                || branch.origin == Branch::Origin::Apex || !branch.own_branches.empty()
                || branch.is_drawn_leaf())
                continue;
            if (runs_over(places, branch, near))
                styles[std::move(target)] = path;
        }
    if (styles.empty())
        styles[path] = "";
    return styles;
}

} // namespace tractus::silhouette
