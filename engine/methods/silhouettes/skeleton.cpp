#include "engine/methods/silhouettes/skeleton.h"

#include "engine/base/parallel.h"
#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/own_outline.h"
#include "engine/methods/silhouettes/sibling_style.h"

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

enum class Which { All, Refined };

// How the crowns of one level are looked into.
struct LevelInference {
    InferenceOptions usual;
    InferenceOptions outlined;
    Which which = Which::All;
    // Whether branches that somebody drew on bear others than those.
    enum class Besides { Nothing, Inferred } besides = Besides::Inferred;
};

// With the branches that were drawn on the bearer, as they were drawn. Where its crown is too small
// for any, a lens around it is its crown.
Result<BranchingSystem> system_with_strokes(Branch const& bearer, InferenceOptions options)
{
    options.drawn_bases = InferenceOptions::DrawnBases::Anywhere;
    auto const trunk = bearer.line(17);
    auto const& crown = bearer.is_outlined() ? bearer.own_outline : bearer.crown;
    auto system = infer_system({ { crown }, trunk, bearer.own_branches }, options);
    if (!system)
        system = infer_system({ { lens_around(bearer.path.curve) }, trunk, bearer.own_branches },
                              options);
    if (system)
        for (auto& branch : system->branches)
            if (branch.origin == Branch::Origin::Drawn) {
                branch.stroke = bearer.own_branches[branch.number];
                branch.path.curve.end = branch.stroke.back(); // Which the frame has rounded.
            }
    return system;
}

void keep_drawn(BranchingSystem& system)
{
    std::erase_if(system.branches, [](Branch const& branch) {
        return branch.origin != Branch::Origin::Drawn && branch.origin != Branch::Origin::Apex;
    });
    system.coverage_after = coverage_of(system);
}

Result<BranchingSystem> system_below(Branch const& branch, LevelInference const& options)
{
    auto const& how = branch.is_outlined() ? options.outlined : options.usual;
    auto const& crown = branch.is_outlined() ? branch.own_outline : branch.crown;
    bool const has_strokes = !branch.own_branches.empty();
    auto system = has_strokes ? TRY(system_with_strokes(branch, how))
                              : TRY(infer_system({ { crown }, branch.line(17), {} }, how));
    system.is_of_own_outline = branch.is_outlined();
    system.is_in_siblings_style = branch.style_to == StyleTo::Siblings;
    if (has_strokes && !branch.is_outlined() && options.besides == LevelInference::Besides::Nothing)
        keep_drawn(system);
    return system;
}

// Gives the branches from `first_system` on systems of their own. What cannot be inferred bears
// nothing.
void infer_level(Skeleton& skeleton, std::size_t first_system, LevelInference const& options)
{
    std::vector<Wanted> wanted;
    for (auto s = first_system; s < skeleton.systems.size(); ++s)
        for (std::size_t b = 0; b < skeleton.systems[s].branches.size(); ++b)
            if (auto const& branch = skeleton.systems[s].branches[b]; !branch.model
                && skeleton.system_of[s][b] == kNoSystem
                && (options.which == Which::All || branch.is_refined()))
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

// The styles of the branches that somebody drew on for their siblings, too, by their places on the
// trunk.
std::vector<BearerStyle> styles_for_siblings(Skeleton const& skeleton)
{
    std::vector<BearerStyle> styles;
    auto const& tree = skeleton.systems[0];
    for (std::size_t i = 0; i < tree.branches.size(); ++i) {
        auto const below = skeleton.system_of[0][i];
        if (tree.branches[i].style_to != StyleTo::Siblings || below == kNoSystem)
            continue;
        auto style = bearer_style(tree.branches[i], skeleton.systems[below]);
        if (!style.children.empty())
            styles.push_back(std::move(style));
    }
    std::stable_sort(styles.begin(), styles.end(),
                     [](BearerStyle const& a, BearerStyle const& b) { return a.t < b.t; });
    return styles;
}

// Gives the trunk's branches that nobody drew on systems in the style of those that somebody did.
void follow_styles(Skeleton& skeleton, LevelInference const& inference, std::uint64_t seed)
{
    auto const styles = styles_for_siblings(skeleton);
    if (styles.empty())
        return;
    auto options = inference.usual;
    options.fill.most_branches = 0;
    auto& tree = skeleton.systems[0];
    std::vector<std::optional<BranchingSystem>> made(tree.branches.size());
    parallel_for(made.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i) {
            auto const& branch = tree.branches[i];
            if (branch.is_refined())
                continue;
            if (auto system = infer_system({ { branch.crown }, branch.line(17), {} }, options)) {
                take_style(*system, branch, styles, seed);
                made[i] = *std::move(system);
            }
        }
    });
    for (std::size_t i = 0; i < made.size(); ++i) {
        auto& branch = skeleton.systems[0].branches[i];
        if (branch.is_refined())
            continue;
        branch.model.reset();
        branch.from_model = {};
        skeleton.system_of[0][i] = made[i] ? skeleton.systems.size() : kNoSystem;
        if (!made[i])
            continue;
        skeleton.system_of.emplace_back(made[i]->branches.size(), kNoSystem);
        skeleton.systems.push_back(*std::move(made[i]));
    }
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

Result<BranchingSystem> infer_on_trunk(Drawing const& drawing, SkeletonOptions const& options)
{
    auto tree = TRY(infer_system(drawing, styled(options.tree, options.styles, 0)));
    for (std::size_t i = 0; i < std::min(options.names.size(), tree.branches.size()); ++i)
        tree.branches[i].name = options.names[i];
    take_own_outlines(tree, drawing.own_outlines);
    take_own_branches(tree, drawing.own_branches);
    return tree;
}

Result<Skeleton> infer_skeleton(Drawing const& drawing, SkeletonOptions const& options)
{
    Skeleton skeleton;
    skeleton.systems.push_back(TRY(infer_on_trunk(drawing, options)));
    auto const& branches = skeleton.systems[0].branches;
    skeleton.system_of.emplace_back(branches.size(), kNoSystem);
    bool const has_style = std::any_of(branches.begin(), branches.end(), [](Branch const& branch) {
        return branch.style_to == StyleTo::Siblings;
    });
    auto below = options.below;
    auto outlined = options.outlined;
    below.outline.least_area_mm2 = 0;
    outlined.outline.least_area_mm2 = 0;
    std::size_t first = 0;
    for (int level = 1; level < std::max(options.levels, 2); ++level) {
        auto const next = skeleton.systems.size();
        bool const is_usual = level < options.levels;
        LevelInference inference { .usual = styled(below, options.styles, level),
                                   .outlined = styled(outlined, options.styles, level),
                                   .which = is_usual ? Which::All : Which::Refined,
                                   .besides = is_usual ? LevelInference::Besides::Inferred
                                                       : LevelInference::Besides::Nothing };
        bool const goes_to_siblings = level == 1 && has_style;
        if (goes_to_siblings)
            inference.which = Which::Refined;
        infer_level(skeleton, first, inference);
        if (goes_to_siblings)
            follow_styles(skeleton, inference, options.seed);
        first = next;
    }
    return skeleton;
}

std::optional<std::size_t> number_of(BranchingSystem const& system, std::string const& name)
{
    for (std::size_t i = 0; i < system.branches.size(); ++i)
        if (name_of(system.branches[i]) == name)
            return i;
    return std::nullopt;
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
