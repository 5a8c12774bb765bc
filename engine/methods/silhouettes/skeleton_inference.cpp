#include "engine/base/parallel.h"
#include "engine/methods/silhouettes/chosen_style.h"
#include "engine/methods/silhouettes/level_inference.h"
#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/own_outline.h"
#include "engine/methods/silhouettes/sibling_style.h"
#include "engine/methods/silhouettes/skeleton.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

namespace tractus::silhouette {

namespace {

// The drawing's lines on children of the branch `parent`, each with its branch's name instead of
// the path.
template<typename Drawn>
std::vector<Drawn> drawn_on(std::vector<Drawn> const& lines, std::string_view parent)
{
    std::vector<Drawn> result;
    for (auto const& own : lines)
        if (!own.branch.empty() && parent_in(own.branch) == parent) {
            result.push_back(own);
            result.back().branch = last_name_in(own.branch);
        }
    return result;
}

void name_branches(BranchingSystem& system, BranchNames const& names, std::string const& parent)
{
    auto const found = names.find(parent);
    if (found == names.end())
        return;
    auto const count = std::min(found->second.size(), system.branches.size());
    for (std::size_t i = 0; i < count; ++i)
        system.branches[i].name = found->second[i];
}

// Assigns touches to the branches whose outlines were drawn; touches at other outlines have no
// effect.
void give_touches(BranchingSystem& system, std::vector<BumpTouch> const& touches)
{
    for (auto touch : touches) {
        auto const i = number_of(system, std::exchange(touch.branch, ""));
        if (i && system.branches[*i].is_outlined() && !system.branches[*i].leaf)
            system.branches[*i].touches.push_back(std::move(touch));
    }
}

void take_lines(BranchingSystem& system, Drawing const& drawing, std::string const& parent)
{
    take_own_outlines(system, drawn_on(drawing.own_outlines, parent));
    take_own_branches(system, drawn_on(drawing.own_branches, parent));
    give_touches(system, drawn_on(drawing.touches, parent));
    spread_leaves(system, [&](Branch const& branch) {
        auto const name = name_of(branch);
        return !drawing.styles.contains(parent.empty() ? name : parent + kPathSeparator + name);
    });
}

class Inference {
public:
    Inference(Drawing& drawing, SkeletonOptions const& options, BranchNamer* namer)
        : drawing_(drawing)
        , options_(options)
        , namer_(namer)
    {
    }

    Result<Skeleton> run()
    {
        add(TRY(infer_crown_system(drawing_, styled(options_.tree, options_.styles, 0))), kNoParent,
            {});
        auto below = options_.below;
        auto outlined = options_.outlined;
        below.outline.min_area_mm2 = 0;
        outlined.outline.min_area_mm2 = 0;
        skeleton_.surface = drawing_.surface;
        std::size_t first = 0;
        // From level `options_.levels` on, a branch has children only if something was drawn on it
        // or if it follows a style.
        for (int level = 1; first < skeleton_.systems.size(); ++level) {
            bool const is_usual = level < options_.levels;
            LevelInference const how { .usual = styled(below, options_.styles, level),
                                       .outlined = styled(outlined, options_.styles, level),
                                       .which = is_usual ? Which::All : Which::Refined,
                                       .besides = is_usual ? LevelInference::Besides::Inferred
                                                           : LevelInference::Besides::Nothing };
            Level const systems { first, skeleton_.systems.size() };
            find_targets(systems);
            infer_level(systems, how);
            for (auto s = systems.first; s < systems.last; ++s)
                follow_styles(s, how);
            follow_chosen(how);
            for (auto s = systems.first; s < systems.last; ++s)
                hand_down(s);
            first = systems.last;
        }
        return std::move(skeleton_);
    }

private:
    static constexpr BranchRef kNoParent { kNoSystem, 0 };

    // A range of systems whose branches are inferred together.
    struct Level {
        std::size_t first;
        std::size_t last; // Index one past the last system.
    };

    // A branch that takes another branch's style.
    struct Target {
        BranchRef at;
        BranchRef source;
    };

    Branch& branch(BranchRef const& at) { return skeleton_.systems[at.system].branches[at.branch]; }

    void add(BranchingSystem system, BranchRef const& parent,
             std::vector<std::size_t> const& parents)
    {
        auto const path = parent.system == kNoSystem ? std::string() : skeleton_.path_of(parent);
        name_branches(system, options_.names, path);
        if (namer_)
            namer_->name({ .system = system,
                           .index = skeleton_.systems.size(),
                           .parent = path,
                           .parent_system = parent.system,
                           .parents = parents },
                         drawing_);
        take_lines(system, drawing_, path);
        skeleton_.system_of.emplace_back(system.branches.size(), kNoSystem);
        skeleton_.parents.push_back(path);
        from_above_.emplace_back();
        skeleton_.systems.push_back(std::move(system));
    }

    // Makes `made` the system of the children of `parent`, which has no children if `made` is
    // empty.
    void bear(BranchRef const& parent, std::optional<BranchingSystem> made,
              std::vector<std::size_t> const& parents)
    {
        auto& below = skeleton_.system_of[parent.system][parent.branch];
        below = kNoSystem;
        if (!made || made->branches.empty())
            return;
        below = skeleton_.systems.size();
        add(*std::move(made), parent, parents);
    }

    // Finds the branches of a level that take a chosen style: those without drawn children whose
    // source exists.
    void find_targets(Level const& level)
    {
        targets_.clear();
        for (auto const& [path, from] : drawing_.styles) {
            auto const at = skeleton_.at(path);
            auto const source = skeleton_.at(source_of(drawing_.styles, path));
            if (!at || !source || at->system < level.first || at->system >= level.last
                || skeleton_.parents[at->system] != parent_in(path)
                || !branch(*at).own_branches.empty() || branch(*at).is_drawn_leaf())
                continue;
            targets_.push_back({ *at, *source });
        }
    }

    bool is_target(BranchRef const& at) const
    {
        return std::any_of(targets_.begin(), targets_.end(), [&](Target const& target) {
            return target.at.system == at.system && target.at.branch == at.branch;
        });
    }

    // Indices of a branch and its copies.
    std::vector<std::size_t> with_copies(BranchRef const& of) const
    {
        std::vector<std::size_t> numbers;
        auto const& branches = skeleton_.systems[of.system].branches;
        for (std::size_t i = 0; i < branches.size(); ++i)
            if (i == of.branch || branches[i].model == of.branch)
                numbers.push_back(i);
        return numbers;
    }

    // True if the system's branches follow a style: that of a sibling that was drawn on, or one
    // from the level above.
    bool has_style(std::size_t system, Which usual) const
    {
        if (usual == Which::All && !from_above_[system].empty())
            return true;
        auto const& branches = skeleton_.systems[system].branches;
        return std::any_of(branches.begin(), branches.end(), [](Branch const& branch) {
            return branch.style_to != StyleScope::None;
        });
    }

    // True if the children of a branch are inferred together with those of its level. This includes
    // a target that has copies, because the copies keep the inferred children.
    bool is_wanted(BranchRef const& at, Which which) const
    {
        auto const& branch = skeleton_.systems[at.system].branches[at.branch];
        if (branch.model || branch.leaf)
            return false;
        if (is_target(at))
            return which == Which::All && with_copies(at).size() > 1;
        return which == Which::All || branch.is_refined();
    }

    // Infers a system for each branch of a level. A branch whose crown is too small has no
    // children.
    void infer_level(Level const& level, LevelInference const& how)
    {
        std::vector<BranchRef> wanted;
        for (auto s = level.first; s < level.last; ++s) {
            auto const which = has_style(s, how.which) ? Which::Refined : how.which;
            for (std::size_t b = 0; b < skeleton_.systems[s].branches.size(); ++b)
                if (is_wanted({ s, b }, which))
                    wanted.push_back({ s, b });
        }
        std::vector<std::optional<BranchingSystem>> made(wanted.size());
        parallel_for(wanted.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (auto i = begin; i < end; ++i)
                if (auto system = system_below(branch(wanted[i]), how))
                    made[i] = *std::move(system);
        });
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            auto const& [s, b] = wanted[i];
            auto const parents
                = has_style(s, how.which) ? std::vector<std::size_t> { b } : with_copies(wanted[i]);
            bear(wanted[i], std::move(made[i]), parents);
            for (auto const copy : with_copies(wanted[i]))
                skeleton_.system_of[s][copy] = skeleton_.system_of[s][b];
        }
    }

    // The style that a branch passes on; a style without children if the branch has no children.
    ParentStyle style_of(BranchRef const& at)
    {
        auto const below = skeleton_.system_of[at.system][at.branch];
        if (below == kNoSystem)
            return {};
        auto const& source = branch(at);
        if (!source.model)
            return parent_style(source, skeleton_.systems[below]);
        // A copy has its model's children, transformed to its own place.
        auto style = parent_style(branch({ at.system, *source.model }), skeleton_.systems[below]);
        double const size = source.from_model.turn.norm();
        style.spacing *= size;
        style.deviation *= size;
        return style;
    }

    // Styles of those branches of a system that pass their style on to siblings, sorted by
    // position.
    std::vector<ParentStyle> styles_for_siblings(std::size_t system)
    {
        std::vector<ParentStyle> styles;
        for (std::size_t i = 0; i < skeleton_.systems[system].branches.size(); ++i) {
            if (branch({ system, i }).style_to == StyleScope::None)
                continue;
            auto style = style_of({ system, i });
            style.includes_deeper_levels = branch({ system, i }).style_to == StyleScope::Deeper;
            if (!style.children.empty())
                styles.push_back(std::move(style));
        }
        std::stable_sort(styles.begin(), styles.end(),
                         [](ParentStyle const& a, ParentStyle const& b) { return a.t < b.t; });
        return styles;
    }

    // The children of a branch in a given style; no value if nothing can be inferred in its crown.
    std::optional<BranchingSystem> in_style(Branch const& parent,
                                            std::span<ParentStyle const> styles,
                                            LevelInference const& how) const
    {
        if (styles.empty() || styles.front().children.empty())
            return std::nullopt;
        auto options = parent.is_outlined() ? how.outlined : how.usual;
        options.fill.most_branches = 0;
        auto const& crown = parent.is_outlined() ? parent.own_outline : parent.crown;
        auto system = infer_system({ { crown }, parent.line(17), {} }, options);
        if (!system)
            return std::nullopt;
        take_style(*system, parent, styles, options_.seed);
        return *std::move(system);
    }

    // Gives branches that were not drawn on the style of siblings that were drawn on or, without
    // such siblings, the style from the level above.
    void follow_styles(std::size_t s, LevelInference const& how)
    {
        auto styles = styles_for_siblings(s);
        if (styles.empty() && how.which == Which::All)
            styles = from_above_[s];
        if (styles.empty())
            return;
        auto const count = skeleton_.systems[s].branches.size();
        std::vector<std::optional<BranchingSystem>> made(count);
        auto const follows = [&](std::size_t i) {
            auto const& one = branch({ s, i });
            return !one.is_refined() && !one.leaf && !is_target({ s, i });
        };
        parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
            for (auto i = begin; i < end; ++i)
                if (follows(i))
                    made[i] = in_style(branch({ s, i }), styles, how);
        });
        for (std::size_t i = 0; i < count; ++i)
            if (follows(i))
                stand_alone({ s, i }, std::move(made[i]));
    }

    // Passes styles that apply to deeper levels on from a system to the systems of its branches.
    void hand_down(std::size_t s)
    {
        auto styles = styles_for_siblings(s);
        std::erase_if(styles,
                      [](ParentStyle const& style) { return !style.includes_deeper_levels; });
        auto const& handed = styles.empty() ? from_above_[s] : styles;
        if (handed.empty())
            return;
        for (auto const below : skeleton_.system_of[s])
            if (below != kNoSystem)
                from_above_[below] = handed;
    }

    // Gives the branches in `targets_` their chosen styles.
    void follow_chosen(LevelInference const& how)
    {
        std::vector<std::optional<BranchingSystem>> made;
        for (auto const& target : targets_)
            made.push_back(
                in_style(branch(target.at), std::array { style_of(target.source) }, how));
        for (std::size_t i = 0; i < made.size(); ++i) {
            branch(targets_[i].at).style_from = skeleton_.path_of(targets_[i].source);
            stand_alone(targets_[i].at, std::move(made[i]));
            if (branch(targets_[i].source).leaf)
                take_leaf(branch(targets_[i].at), branch(targets_[i].source),
                          skeleton_.systems[targets_[i].at.system].outline);
        }
    }

    // Gives a branch its own system; it is no longer a copy.
    void stand_alone(BranchRef const& at, std::optional<BranchingSystem> made)
    {
        branch(at).model.reset();
        branch(at).from_model = {};
        bear(at, std::move(made), { at.branch });
    }

    Drawing& drawing_;
    SkeletonOptions const& options_;
    BranchNamer* namer_;
    Skeleton skeleton_;
    std::vector<Target> targets_; // Branches of the current level that take a chosen style.
    // Styles from the level above for the branches of each system.
    std::vector<std::vector<ParentStyle>> from_above_;
};

} // namespace

Result<BranchingSystem> infer_on_trunk(Drawing const& drawing, SkeletonOptions const& options)
{
    auto tree = TRY(infer_crown_system(drawing, styled(options.tree, options.styles, 0)));
    name_branches(tree, options.names, "");
    take_lines(tree, drawing, "");
    return tree;
}

Result<Skeleton> infer_skeleton(Drawing const& drawing, SkeletonOptions const& options)
{
    auto lines = drawing;
    return Inference(lines, options, nullptr).run();
}

Result<Skeleton> infer_skeleton(Drawing& drawing, SkeletonOptions const& options,
                                BranchNamer& namer)
{
    return Inference(drawing, options, &namer).run();
}

} // namespace tractus::silhouette
