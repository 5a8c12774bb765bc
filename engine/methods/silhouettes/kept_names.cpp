#include "engine/methods/silhouettes/kept_names.h"

#include "engine/methods/silhouettes/match.h"
#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/own_outline.h"

#include <algorithm>
#include <set>
#include <utility>

namespace tractus::silhouette {

namespace {

// Transforms an earlier system so that its trunk coincides with the later system's. Branches are
// then compared by their position on the parent, even if the parent has moved.
BranchingSystem laid_on(BranchingSystem system, BranchingSystem const& later)
{
    Vec2 const from = system.trunk.back() - system.trunk.front();
    Vec2 const to = later.trunk.back() - later.trunk.front();
    if (from.squaredNorm() <= 0)
        return system;
    Similarity const way { .from = system.trunk.front(),
                           .to = later.trunk.front(),
                           .turn = Vec2(from.dot(to), cross(from, to)) / from.squaredNorm() };
    system.outline = way.points(system.outline);
    for (auto& branch : system.branches)
        branch.crown = way.points(branch.crown);
    return system;
}

// `path` after the branch `from` was renamed to `to`: applies to the branch itself and its
// descendants.
std::string moved_path(std::string const& path, std::string const& from, std::string const& to)
{
    if (path == from)
        return to;
    bool const is_below = path.starts_with(from) && path[from.size()] == kPathSeparator;
    return is_below ? to + path.substr(from.size()) : path;
}

// True if anything was drawn on branches or styles were chosen for them.
bool is_drawn_on(Drawing const& drawing)
{
    return drawing.is_refined() || !drawing.styles.empty();
}

// Records each inferred system before drawn lines are applied to its branches.
class SystemRecord final : public BranchNamer {
public:
    void name(NewSystem const& made, Drawing& drawing) override
    {
        if (is_drawn_on(drawing))
            systems.push_back(made.system);
    }

    std::vector<BranchingSystem> systems; // Systems in the order of the skeleton.
};

bool are_on_the_same(Drawing const& one, Drawing const& other)
{
    auto const same = [](auto const& a, auto const& b) { return a.branch == b.branch; };
    auto const all = [&](auto const& a, auto const& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
    };
    return one.styles == other.styles && all(one.own_outlines, other.own_outlines)
        && all(one.own_branches, other.own_branches) && all(one.touches, other.touches);
}

// Updates all lines and styles on a renamed branch and its descendants.
void move_below(Drawing& drawing, std::string const& from, std::string const& to)
{
    if (from.empty())
        return;
    for (auto& own : drawing.own_outlines)
        if (own.branch != from)
            own.branch = moved_path(own.branch, from, to);
    for (auto& own : drawing.own_branches)
        if (own.branch != from)
            own.branch = moved_path(own.branch, from, to);
    for (auto& touch : drawing.touches)
        touch.branch = moved_path(touch.branch, from, to);
    ChosenStyles styles;
    for (auto const& [target, source] : drawing.styles)
        styles.emplace(moved_path(target, from, to), moved_path(source, from, to));
    drawing.styles = std::move(styles);
}

// Gives lines on the trunk's branches a path that no branch has, so that they are reassigned.
void forget_trunk_branches(Drawing& drawing)
{
    std::set<std::string> drawn_on;
    for (auto const& own : drawing.own_outlines)
        drawn_on.insert(own.branch.substr(0, own.branch.find(kPathSeparator)));
    for (auto const& own : drawing.own_branches)
        drawn_on.insert(own.branch.substr(0, own.branch.find(kPathSeparator)));
    for (auto const& name : drawn_on) {
        auto const lost = "?" + name;
        move_below(drawing, name, lost);
        for (auto& own : drawing.own_outlines)
            own.branch = moved_path(own.branch, name, lost);
        for (auto& own : drawing.own_branches)
            own.branch = moved_path(own.branch, name, lost);
    }
}

bool is_lost(std::string const& path, BranchNamer::NewSystem const& made)
{
    return parent_in(path) == made.parent
        && !number_of(made.system, std::string(last_name_in(path)));
}

std::string path_in(BranchNamer::NewSystem const& made, std::size_t branch)
{
    auto const name = name_of(made.system.branches[branch]);
    return made.parent.empty() ? name : made.parent + kPathSeparator + name;
}

// Reassigns outlines whose branches are gone to the new branches that the outlines surround.
void settle_outlines(Drawing& drawing, BranchNamer::NewSystem const& made)
{
    auto const is_outlined = [&](std::string const& path) {
        return std::any_of(drawing.own_outlines.begin(), drawing.own_outlines.end(),
                           [&](OwnOutline const& own) { return own.branch == path; });
    };
    for (auto& own : drawing.own_outlines) {
        if (!is_lost(own.branch, made))
            continue;
        auto const around = branch_in(made.system, own.outline);
        if (!around || is_outlined(path_in(made, *around)))
            continue;
        auto const from = std::exchange(own.branch, path_in(made, *around));
        move_below(drawing, from, own.branch);
    }
}

// Reassigns drawn branches whose parents are gone to the new branches on which the drawn ones
// begin.
void settle_branches(Drawing& drawing, BranchNamer::NewSystem const& made,
                     std::vector<std::optional<std::size_t>> const& partners)
{
    for (auto& own : drawing.own_branches) {
        if (!is_lost(own.branch, made))
            continue;
        auto const parent = parent_of(made.system, own.line);
        if (!parent || (*parent < partners.size() && partners[*parent]))
            continue;
        auto const from = std::exchange(own.branch, path_in(made, *parent));
        move_below(drawing, from, own.branch);
    }
}

} // namespace

// The earlier system that corresponds to a new one: that of the earlier branch that matches the new
// system's parent or a copy of the parent.
std::optional<std::size_t> KeptNames::earlier_system(NewSystem const& made) const
{
    if (made.parent_system == kNoSystem)
        return 0;
    auto const before = earlier_of_[made.parent_system];
    if (!before)
        return std::nullopt;
    for (auto const parent : made.parents)
        if (auto const partner = partners_[made.parent_system][parent])
            if (auto const below = earlier_.skeleton.system_of[*before][*partner];
                below != kNoSystem)
                return below;
    return std::nullopt;
}

void KeptNames::name(NewSystem const& made, Drawing& drawing)
{
    auto const before = earlier_system(made);
    auto& partners = partners_.emplace_back();
    earlier_of_.push_back(before);
    has_replaced_children_ = !parents_.insert(made.parent).second || has_replaced_children_;
    if (before) {
        auto const& earlier = earlier_.bare(*before);
        bool const is_on_trunk = made.parent_system == kNoSystem;
        partners
            = match_branches(is_on_trunk ? earlier : laid_on(earlier, made.system), made.system);
        auto& names = names_[made.parent];
        for (std::size_t i = 0; i < partners.size(); ++i)
            names.push_back(partners[i] ? name_of(earlier.branches[*partners[i]])
                                        : fresh_ + name_of(made.system.branches[i]));
        for (std::size_t i = 0; i < partners.size(); ++i)
            made.system.branches[i].name = names[i];
    } else {
        partners.resize(made.system.branches.size());
    }
    settle_outlines(drawing, made);
    settle_branches(drawing, made, partners);
    if (is_drawn_on(drawing))
        systems_.push_back(made.system);
}

Result<InferredDrawing> infer_drawing(Drawing const& drawing, SkeletonOptions const& options)
{
    auto lines = drawing;
    SystemRecord record;
    auto skeleton = TRY(infer_skeleton(lines, options, record));
    return InferredDrawing { std::move(skeleton), std::move(record.systems) };
}

Result<Renamed> kept_names(InferredDrawing const& earlier, Drawing& after, SkeletonOptions options,
                           std::string const& fresh)
{
    KeptNames kept(earlier, fresh);
    options.names.clear();
    bool const is_leaf = std::exchange(after.is_leaf, false);
    auto const as_given = after;
    auto skeleton = TRY(infer_skeleton(after, options, kept));
    after.is_leaf = is_leaf;
    Renamed renamed { kept.names() };
    if (!is_leaf && !kept.has_replaced_children() && are_on_the_same(as_given, after))
        renamed.inferred = { std::move(skeleton), kept.take_systems() };
    return renamed;
}

Result<Renamed> kept_names(DrawingToInfer const& before, Drawing& after,
                           SkeletonOptions const& options, std::string const& fresh)
{
    auto drawing = before.drawing;
    drawing.is_leaf = false;
    return kept_names(TRY(infer_drawing(drawing, before.options)), after, options, fresh);
}

void ReassigningNamer::name(NewSystem const& made, Drawing& drawing)
{
    if (made.parent_system == kNoSystem)
        forget_trunk_branches(drawing);
    settle_outlines(drawing, made);
    settle_branches(drawing, made, {});
}

} // namespace tractus::silhouette
