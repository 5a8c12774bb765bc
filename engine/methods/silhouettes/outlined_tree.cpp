#include "engine/methods/silhouettes/outlined_tree.h"

#include "engine/base/random.h"
#include "engine/methods/silhouettes/match.h"
#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/own_outline.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::silhouette {

namespace {

constexpr double kShortestTrunk_mm = 5;

bool same_ink(Stroke const& one, Stroke const& other)
{
    return one.tips.id() == other.tips.id();
}

bool same_on_branches(std::vector<DrawnOnBranch> const& one,
                      std::vector<DrawnOnBranch> const& other)
{
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](DrawnOnBranch const& a, DrawnOnBranch const& b) {
                          return a.id == b.id && a.branch == b.branch && a.style_to == b.style_to
                              && same_ink(a.stroke, b.stroke);
                      });
}

bool same(OutlinedTree const& one, OutlinedTree const& other)
{
    return same_ink(one.trunk, other.trunk) && same_ink(one.outline, other.outline)
        && std::equal(one.branches.begin(), one.branches.end(), other.branches.begin(),
                      other.branches.end(),
                      [](DrawnBranch const& a, DrawnBranch const& b) {
                          return a.id == b.id && same_ink(a.stroke, b.stroke);
                      })
        && one.names == other.names && one.form == other.form && one.scale == other.scale
        && same_on_branches(one.own_outlines, other.own_outlines)
        && same_on_branches(one.own_branches, other.own_branches);
}

Result<std::vector<Vec2>> points_of(Stroke const& stroke)
{
    std::vector<Vec2> points;
    for (auto const& tip : TRY(stroke.tips.in_memory()))
        points.emplace_back(tip.position_mm.head<2>());
    return points;
}

// A pen gives far more places than a line has bends: a drawing has its limit.
Result<std::vector<Vec2>> line_of(Stroke const& stroke)
{
    constexpr std::size_t kMostPoints = 2000;
    auto points = TRY(points_of(stroke));
    if (points.size() > kMostPoints)
        points = resampled_line(points, kMostPoints);
    return points;
}

Result<void> check_scale(double scale)
{
    if (!(scale > 0 && std::isfinite(scale)))
        return fail(Fault::User,
                    fmt::format("a tree cannot be shown {} times as large as it is", scale));
    return {};
}

SkeletonOptions options_of(OutlinedTree const& tree)
{
    auto options = skeleton_options(tree.form);
    if (!tree.names.empty())
        options.names = tree.names[0];
    return options;
}

// A stem along the trunk's line alone.
Result<Plant> bare_stem(std::vector<Vec2> const& trunk, double scale)
{
    constexpr std::size_t kNodes = 17;
    constexpr double kThickest = 0.02; // Radius at the foot, of the stem's length.
    double const length_mm = length_of(trunk);
    if (length_mm < kShortestTrunk_mm)
        return fail(Fault::User,
                    fmt::format("the trunk is shorter than {:g} mm: draw it from the foot upwards",
                                kShortestTrunk_mm));
    Plant plant;
    plant.materials.push_back({ .name = "bark", .base_color = TreeOptions {}.bark_color });
    plant.axes.push_back({ .segment_count = kNodes - 1 });
    plant.segment_material.resize(kNodes - 1, 0);
    auto const nodes = resampled_line(trunk, kNodes);
    for (std::size_t i = 0; i < kNodes; ++i) {
        Vec2 const up = (nodes[i] - nodes[0]) / scale;
        double const tapered = 1 - 0.8 * static_cast<double>(i) / (kNodes - 1);
        plant.node_position_mm.emplace_back(up.x(), 0, up.y());
        plant.node_radius_mm.push_back(static_cast<float>(tapered * kThickest * length_mm / scale));
    }
    return plant;
}

// Two drawings of a tree.
struct Redrawn {
    Skeleton const& earlier;
    Skeleton const& later;
    std::string const& fresh;
};

// An earlier system laid on a later one, trunk on trunk: what is compared is where branches stand
// on what bears them, wherever that has gone.
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

using Partners = std::vector<std::optional<std::size_t>>;

// What branches of a later system are called whose partners in an earlier one are known.
std::vector<std::string> names_after(BranchingSystem const& before, BranchingSystem const& after,
                                     Partners const& partners, std::string const& fresh)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < partners.size(); ++i)
        names.push_back(partners[i] ? name_of(before.branches[*partners[i]])
                                    : fresh + name_of(after.branches[i]));
    return names;
}

// Names what stands on the branches of a later system that have partners in an earlier one.
void name_below(Redrawn const& redrawn, std::size_t earlier, std::size_t later,
                Partners const& partners, std::vector<std::vector<std::string>>& names)
{
    for (std::size_t i = 0; i < partners.size(); ++i) {
        if (!partners[i])
            continue;
        auto const below_before = redrawn.earlier.system_of[earlier][*partners[i]];
        auto const below_after = redrawn.later.system_of[later][i];
        if (below_before == kNoSystem || below_after == kNoSystem || !names[below_after].empty())
            continue;
        auto const& before = redrawn.earlier.systems[below_before];
        auto const& after = redrawn.later.systems[below_after];
        auto const below = match_branches(laid_on(before, after), after);
        names[below_after] = names_after(before, after, below, redrawn.fresh);
        name_below(redrawn, below_before, below_after, below, names);
    }
}

// The trunk's branches alone, without what was drawn on them: whose that is does not depend on it.
Result<BranchingSystem> inferred_on_trunk(OutlinedTree tree)
{
    tree.own_outlines.clear();
    tree.own_branches.clear();
    return infer_on_trunk(TRY(drawing_of(tree)), options_of(tree));
}

// Where nothing was drawn on them they are those of the tree's skeleton, which is there already.
Result<BranchingSystem> inferred_on_trunk(OutlinedTree const& tree, Skeleton const& skeleton)
{
    return tree.is_refined() ? inferred_on_trunk(tree) : skeleton.systems[0];
}

bool is_outlined(OutlinedTree const& tree, std::string const& branch)
{
    return std::any_of(tree.own_outlines.begin(), tree.own_outlines.end(),
                       [&](DrawnOnBranch const& own) { return own.branch == branch; });
}

// Outlines whose branches are gone go to the ones that they lie around.
Result<void> settle_outlines(OutlinedTree& tree, BranchingSystem const& inferred)
{
    auto const& branches = inferred.branches;
    for (auto& own : tree.own_outlines) {
        if (number_of(inferred, own.branch))
            continue;
        auto const around = branch_in(inferred, TRY(line_of(own.stroke)));
        if (around && !is_outlined(tree, name_of(branches[*around])))
            own.branch = name_of(branches[*around]);
    }
    return {};
}

// Branches whose bearers are gone go to the new ones that they begin on.
Result<void> settle_branches(OutlinedTree& tree, BranchingSystem const& inferred,
                             Partners const& partners)
{
    for (auto& own : tree.own_branches) {
        if (number_of(inferred, own.branch))
            continue;
        auto const bearer = bearer_of(inferred, TRY(line_of(own.stroke)));
        if (bearer && !partners[*bearer])
            own.branch = name_of(inferred.branches[*bearer]);
    }
    return {};
}

// For a tree that had no crown for a while: its branches say nothing of those before.
Result<void> find_branches_again(OutlinedTree& tree)
{
    if (!tree.is_refined())
        return {};
    for (auto* const drawn : { &tree.own_outlines, &tree.own_branches })
        for (auto& own : *drawn)
            own.branch.clear();
    auto const inferred = TRY(inferred_on_trunk(tree));
    TRY(settle_outlines(tree, inferred));
    return settle_branches(tree, inferred, Partners(inferred.branches.size()));
}

} // namespace

Result<Drawing> drawing_of(OutlinedTree const& tree)
{
    Drawing drawing;
    if (!tree.outline.tips.empty())
        drawing.outline.push_back(TRY(line_of(tree.outline)));
    drawing.trunk = TRY(line_of(tree.trunk));
    for (auto const& branch : tree.branches)
        drawing.branches.push_back(TRY(line_of(branch.stroke)));
    for (auto const& own : tree.own_outlines)
        drawing.own_outlines.push_back({ own.branch, TRY(line_of(own.stroke)), own.style_to });
    for (auto const& own : tree.own_branches)
        drawing.own_branches.push_back({ own.branch, TRY(line_of(own.stroke)), own.style_to });
    return drawing;
}

Result<Vec2> foot_of(OutlinedTree const& tree)
{
    auto const drawing = TRY(drawing_of(tree));
    if (!drawing.trunk.empty())
        return drawing.trunk.front();
    auto const clean = TRY(clean_drawing(drawing));
    return clean.to_sheet.point(clean.trunk.front());
}

Result<Skeleton> skeleton_of(OutlinedTree const& tree)
{
    auto const drawing = TRY(drawing_of(tree));
    auto skeleton = TRY(infer_skeleton(drawing, options_of(tree)));
    for (std::size_t s = 1; s < std::min(tree.names.size(), skeleton.systems.size()); ++s)
        for (std::size_t i = 0;
             i < std::min(tree.names[s].size(), skeleton.systems[s].branches.size()); ++i)
            skeleton.systems[s].branches[i].name = tree.names[s][i];
    return skeleton;
}

// Asks of which branch a stroke is; no value: of none, or the tree has no outline.
using BranchFinder = Result<std::optional<std::string>>(Drawing const&, std::span<Vec2 const>,
                                                        SkeletonOptions const&);
static Result<std::optional<std::string>> branch_under(OutlinedTree const& tree,
                                                       Stroke const& stroke, BranchFinder& find)
{
    if (tree.outline.tips.empty())
        return std::nullopt;
    auto const drawing = TRY(drawing_of(tree));
    auto const line = TRY(line_of(stroke));
    return find(drawing, line, options_of(tree));
}

Result<std::optional<std::string>> branch_outlined_by(OutlinedTree const& tree,
                                                      Stroke const& stroke)
{
    return branch_under(tree, stroke, branch_outlined_by);
}

Result<OutlinedTree> with_own_outline(OutlinedTree tree, Stroke const& stroke, ItemId id,
                                      StyleTo style_to)
{
    auto drawing = TRY(drawing_of(tree));
    auto line = TRY(line_of(stroke));
    TRY(add_own_outline(drawing, std::move(line), options_of(tree)));
    auto const& branch = drawing.own_outlines.back().branch;
    std::erase_if(tree.own_outlines,
                  [&](DrawnOnBranch const& own) { return own.branch == branch; });
    tree.own_outlines.push_back({ id, stroke, branch, style_to });
    return tree;
}

Result<std::optional<std::string>> branch_borne_by(OutlinedTree const& tree, Stroke const& stroke)
{
    return branch_under(tree, stroke, branch_borne_by);
}

Result<OutlinedTree> with_own_branch(OutlinedTree tree, Stroke const& stroke, ItemId id,
                                     StyleTo style_to)
{
    auto drawing = TRY(drawing_of(tree));
    auto line = TRY(line_of(stroke));
    TRY(add_own_branch(drawing, std::move(line), style_to, options_of(tree)));
    tree.own_branches.push_back({ id, stroke, drawing.own_branches.back().branch, style_to });
    return tree;
}

Result<std::size_t> count_waiting(OutlinedTree const& tree)
{
    if (!tree.is_refined() || tree.outline.tips.empty())
        return tree.own_outlines.size() + tree.own_branches.size();
    auto const inferred = TRY(inferred_on_trunk(tree));
    std::size_t count = 0;
    for (auto const* const drawn : { &tree.own_outlines, &tree.own_branches })
        for (auto const& own : *drawn)
            count += !number_of(inferred, own.branch);
    return count;
}

Result<void> keep_names(OutlinedTree const& before, OutlinedTree& after, std::string const& fresh)
{
    if (after.outline.tips.empty())
        return {};
    if (before.outline.tips.empty())
        return find_branches_again(after);
    after.names.clear();
    auto const earlier = TRY(skeleton_of(before));
    auto const had = TRY(inferred_on_trunk(before, earlier));
    auto later = TRY(skeleton_of(after));
    auto has = TRY(inferred_on_trunk(after, later));
    auto const partners = match_branches(had, has);
    after.names.push_back(names_after(had, has, partners, fresh));
    if (after.is_refined()) {
        for (std::size_t i = 0; i < partners.size(); ++i)
            has.branches[i].name = after.names[0][i];
        TRY(settle_outlines(after, has));
        TRY(settle_branches(after, has, partners));
        later = TRY(skeleton_of(after));
    }
    after.names.resize(later.systems.size());
    name_below({ earlier, later, fresh }, 0, 0, partners, after.names);
    return {};
}

Result<BuiltSource> build_tree(OutlinedTree const& tree, LoadOptions const&)
{
    TRY(check_form(tree.form));
    TRY(check_scale(tree.scale));
    auto const drawing = TRY(drawing_of(tree));
    if (drawing.outline.empty() && !drawing.trunk.empty())
        return BuiltSource { .plant = TRY(bare_stem(drawing.trunk, tree.scale)),
                             .axis_keys = { axis_key(kTrunkName) } };
    auto const skeleton = TRY(skeleton_of(tree));
    auto made = make_tree(skeleton, tree_options(tree.form, drawn_height(skeleton) / tree.scale));
    BuiltSource built { std::move(made.plant), skeleton.systems[0].notes };
    for (auto const& name : made.axis_names)
        built.axis_keys.push_back(axis_key(name));
    return built;
}

// What the drawing leaves open is left to another chance.
static OutlinedTree varied(OutlinedTree tree, SourceVariation const& variation)
{
    constexpr std::uint32_t kStream = 0x7472;
    Random random({ variation.seed ^ tree.form.seed, kStream + variation.stream, variation.plant });
    tree.form.seed = random.next_u64();
    return tree;
}

constexpr SourceKind OutlinedTree::kKind {
    .word = "outlined_tree",
    .build =
        [](void const* drawn, LoadOptions const& options) {
            return build_tree(*static_cast<OutlinedTree const*>(drawn), options);
        },
    .same =
        [](void const* one, void const* other) {
            return same(*static_cast<OutlinedTree const*>(one),
                        *static_cast<OutlinedTree const*>(other));
        },
    .vary = [](void const* drawn, SourceVariation const& variation) -> std::shared_ptr<void const> {
        return std::make_shared<OutlinedTree const>(
            varied(*static_cast<OutlinedTree const*>(drawn), variation));
    },
};

} // namespace tractus::silhouette
