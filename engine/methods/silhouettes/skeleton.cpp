#include "engine/methods/silhouettes/skeleton.h"

#include "engine/base/parallel.h"
#include "engine/methods/silhouettes/own_outline.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <optional>
#include <utility>

namespace tractus::silhouette {

namespace {

// A branch whose crown is to be looked into.
struct Wanted {
    std::size_t system = 0;
    std::size_t branch = 0;
};

enum class Which { All, Outlined };

// How the crowns of one level are looked into.
struct LevelInference {
    InferenceOptions usual;
    InferenceOptions outlined;
    Which which = Which::All;
};

Result<BranchingSystem> system_below(Branch const& branch, LevelInference const& options)
{
    auto trunk = branch.path.curve.points(17);
    if (!branch.is_outlined())
        return infer_system({ { branch.crown }, std::move(trunk), {} }, options.usual);
    auto system = TRY(infer_system({ { branch.own_outline }, std::move(trunk) }, options.outlined));
    system.is_of_own_outline = true;
    return system;
}

// Gives the branches from `first_system` on systems of their own. What cannot be inferred bears
// nothing.
void infer_level(Skeleton& skeleton, std::size_t first_system, LevelInference const& options)
{
    std::vector<Wanted> wanted;
    for (auto s = first_system; s < skeleton.systems.size(); ++s)
        for (std::size_t b = 0; b < skeleton.systems[s].branches.size(); ++b)
            if (auto const& branch = skeleton.systems[s].branches[b];
                !branch.model && (options.which == Which::All || branch.is_outlined()))
                wanted.push_back({ s, b });
    std::vector<std::optional<BranchingSystem>> made(wanted.size());
    parallel_for(wanted.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i) {
            auto const& branch = skeleton.systems[wanted[i].system].branches[wanted[i].branch];
            if (auto system = system_below(branch, options))
                made[i] = *std::move(system);
        }
    });
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (!made[i] || made[i]->branches.empty())
            continue;
        skeleton.system_of[wanted[i].system][wanted[i].branch] = skeleton.systems.size();
        skeleton.system_of.emplace_back(made[i]->branches.size(), kNoSystem);
        skeleton.systems.push_back(*std::move(made[i]));
    }
    for (auto const& [s, b] : wanted)
        for (std::size_t copy = 0; copy < skeleton.system_of[s].size(); ++copy)
            if (skeleton.systems[s].branches[copy].model == b)
                skeleton.system_of[s][copy] = skeleton.system_of[s][b];
}

InferenceOptions styled(InferenceOptions options, std::vector<BranchStyle> const& styles, int level)
{
    auto const i = static_cast<std::size_t>(level);
    if (i >= styles.size() || !styles[i].is_set())
        return options;
    auto const& style = styles[i];
    options.angles
        = BranchingAngles({ { style.unbranched, style.first_angle_deg },
                            { style.unbranched + style.extent(), style.last_angle_deg } },
                          kAngleOver);
    options.unbranched = style.unbranched;
    return options;
}

} // namespace

std::size_t Skeleton::branch_count() const
{
    std::function<std::size_t(std::size_t)> const count_in = [&](std::size_t system) {
        std::size_t count = 0;
        for (auto const below : system_of[system])
            count += 1 + (below == kNoSystem ? 0 : count_in(below));
        return count;
    };
    return systems.empty() ? 0 : count_in(0);
}

std::size_t Skeleton::branches_on(std::size_t branch) const
{
    auto const below = system_of[0][branch];
    return below == kNoSystem ? 0 : systems[below].branches.size();
}

Result<Skeleton> infer_skeleton(Drawing const& drawing, SkeletonOptions const& options)
{
    Skeleton skeleton;
    skeleton.systems.push_back(TRY(infer_system(drawing, styled(options.tree, options.styles, 0))));
    auto& tree = skeleton.systems[0];
    for (std::size_t i = 0; i < std::min(options.names.size(), tree.branches.size()); ++i)
        tree.branches[i].name = options.names[i];
    take_own_outlines(tree, drawing.own_outlines);
    skeleton.system_of.emplace_back(tree.branches.size(), kNoSystem);
    auto below = options.below;
    auto outlined = options.outlined;
    below.outline.least_area_mm2 = 0;
    outlined.outline.least_area_mm2 = 0;
    std::size_t first = 0;
    for (int level = 1; level < std::max(options.levels, 2); ++level) {
        auto const next = skeleton.systems.size();
        infer_level(skeleton, first,
                    { .usual = styled(below, options.styles, level),
                      .outlined = styled(outlined, options.styles, level),
                      .which = level < options.levels ? Which::All : Which::Outlined });
        first = next;
    }
    return skeleton;
}

std::string name_of(Branch const& branch)
{
    if (!branch.name.empty())
        return branch.name;
    switch (branch.origin) {
    case Branch::Origin::Bump:
        return fmt::format("b{}", branch.number);
    case Branch::Origin::Copy:
        return fmt::format("{}{}", branch.number % 2 == 0 ? 'L' : 'R', branch.number / 2);
    case Branch::Origin::Gap:
        return fmt::format("g{}", branch.number);
    case Branch::Origin::Drawn:
        return fmt::format("d{}", branch.number);
    case Branch::Origin::Apex:
        break;
    }
    return "apex";
}

} // namespace tractus::silhouette
