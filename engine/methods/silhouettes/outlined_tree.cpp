#include "engine/methods/silhouettes/outlined_tree.h"

#include "engine/methods/silhouettes/chosen_style.h"
#include "engine/methods/silhouettes/drawn_surface.h"
#include "engine/methods/silhouettes/inferred_trees.h"
#include "engine/methods/silhouettes/kept_names.h"
#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/own_outline.h"
#include "engine/methods/silhouettes/trunk_reach.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::silhouette {

namespace {

Result<std::vector<Vec2>> points_of(Stroke const& stroke)
{
    std::vector<Vec2> points;
    for (auto const& tip : TRY(stroke.tips.in_memory()))
        points.emplace_back(tip.position_mm.head<2>());
    return points;
}

// The points of a stroke, simplified: a pen reports far more points than a line needs, and drawings
// may have only kMaxDrawnPoints points.
Result<std::vector<Vec2>> line_of(Stroke const& stroke)
{
    constexpr std::size_t kMaxPoints = 2000;
    auto points = TRY(points_of(stroke));
    if (points.size() > kMaxPoints)
        points = resampled_line(points, kMaxPoints);
    return points;
}

Result<Vec2> middle_of(Stroke const& stroke)
{
    auto const points = TRY(points_of(stroke));
    if (points.empty())
        return fail(Fault::User, "the touch has no place: touch the paper again");
    return points.size() < 2 ? points.front() : resampled_line(points, 3)[1];
}

} // namespace

SkeletonOptions options_of(OutlinedTree const& tree)
{
    auto options = skeleton_options(tree.form);
    options.names = tree.names;
    return options;
}

Result<Drawing> drawing_of(OutlinedTree const& tree)
{
    Drawing drawing;
    if (!tree.outline.tips.empty())
        drawing.outline.push_back(TRY(line_of(tree.outline)));
    drawing.trunk = TRY(line_of(tree.trunk));
    if (tree.trunk_goes_on_mm > 0 && tree.has_crown() && drawing.trunk.size() > 1)
        go_on(drawing.trunk, tree.trunk_goes_on_mm);
    for (auto const& branch : tree.branches)
        drawing.branches.push_back(TRY(line_of(branch.stroke)));
    for (auto const& own : tree.own_outlines)
        drawing.own_outlines.push_back(
            { own.branch, TRY(line_of(own.stroke)), own.style_to, own.is_leaf });
    for (auto const& own : tree.own_branches)
        drawing.own_branches.push_back({ own.branch, TRY(line_of(own.stroke)), own.style_to });
    drawing.styles = tree.styles;
    for (auto const& touch : tree.touches)
        drawing.touches.push_back({ touch.kind, TRY(place_of(touch)), touch.branch });
    drawing.is_leaf = tree.is_leaf;
    std::vector<CrownLine> lines;
    for (auto const& line : tree.crown_lines)
        lines.push_back(TRY(crown_line_of(line.stroke)));
    TRY(add_surface(drawing, lines, tree.ground_mm));
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
    if (auto const known = tree.inferred ? tree.inferred->find(tree) : nullptr)
        return known->skeleton;
    auto const drawing = TRY(drawing_of(tree));
    return infer_skeleton(drawing, options_of(tree));
}

// Finds the branch to which a stroke belongs; no value if it belongs to none or the tree has no
// outline.
using BranchFinder = Result<std::optional<std::string>>(Drawing const&, std::span<Vec2 const>,
                                                        SkeletonOptions const&, Search);
static Result<std::optional<std::string>>
branch_under(OutlinedTree const& tree, Stroke const& stroke, Search search, BranchFinder& find)
{
    if (!tree.has_crown())
        return std::nullopt;
    auto const drawing = TRY(drawing_of(tree));
    auto const line = TRY(line_of(stroke));
    return find(drawing, line, options_of(tree), search);
}

Result<std::optional<std::string>> branch_outlined_by(OutlinedTree const& tree,
                                                      Stroke const& stroke, Search search)
{
    return branch_under(tree, stroke, search, branch_outlined_by);
}

Result<std::optional<BumpLeaf>> leaf_on_bump(OutlinedTree const& tree, Stroke const& stroke,
                                             Search search)
{
    auto const place = TRY(middle_of(stroke));
    auto const skeleton = TRY(skeleton_of(tree));
    return leaf_on_bump(skeleton, place, search);
}

Result<OutlinedTree> with_own_outline(OutlinedTree tree, Stroke const& stroke,
                                      LineOnBranch const& line)
{
    auto drawing = TRY(drawing_of(tree));
    auto points = TRY(line_of(stroke));
    TRY(add_own_outline(drawing, std::move(points), options_of(tree), line.style_to, line.search,
                        line.is_leaf));
    auto const& own = drawing.own_outlines.back();
    std::erase_if(tree.own_outlines,
                  [&](DrawnOnBranch const& other) { return other.branch == own.branch; });
    tree.own_outlines.push_back(
        { line.id, stroke, own.branch, line.style_to, own.is_leaf, line.of_bump });
    return tree;
}

Result<std::optional<std::string>> parent_of_drawn_branch(OutlinedTree const& tree,
                                                          Stroke const& stroke, Search search)
{
    return branch_under(tree, stroke, search, parent_of_drawn_branch);
}

Result<OutlinedTree> with_own_branch(OutlinedTree tree, Stroke const& stroke,
                                     LineOnBranch const& line)
{
    auto drawing = TRY(drawing_of(tree));
    auto points = TRY(line_of(stroke));
    TRY(add_own_branch(drawing, std::move(points), line.style_to, options_of(tree), line.search));
    tree.own_branches.push_back(
        { line.id, stroke, drawing.own_branches.back().branch, line.style_to });
    return tree;
}

Result<ChosenStyles> styles_copied_by(OutlinedTree const& tree, Stroke const& stroke)
{
    auto const line = TRY(line_of(stroke));
    auto const skeleton = TRY(skeleton_of(tree));
    return copied_by(skeleton, line);
}

Result<OutlinedTree> with_styles(OutlinedTree tree, ChosenStyles const& chosen)
{
    auto const skeleton = TRY(skeleton_of(tree));
    TRY(choose_styles(tree.styles, chosen, skeleton));
    return tree;
}

Result<Vec2> place_of(DrawnTouch const& touch)
{
    return middle_of(touch.stroke);
}

Result<OutlinedTree> with_touch(OutlinedTree tree, DrawnTouch touch, Search search)
{
    if (!tree.has_crown())
        return fail(Fault::User,
                    "the tree has no outline yet: draw the outline of its crown first");
    auto const drawing = TRY(drawing_of(tree));
    auto const place = TRY(place_of(touch));
    auto const found = TRY(touched(drawing, { touch.kind, place }, options_of(tree), search));
    if (found.taken_back) {
        tree.touches.erase(tree.touches.begin() + static_cast<std::ptrdiff_t>(*found.taken_back));
        return tree;
    }
    touch.branch = found.added.branch;
    tree.touches.push_back(std::move(touch));
    return tree;
}

Result<CrownLine> crown_line_of(Stroke const& stroke)
{
    CrownLine line;
    for (auto const& tip : TRY(stroke.tips.in_memory()))
        line.push_back(tip.position_mm);
    return line;
}

Result<OutlinedTree> with_crown_line(OutlinedTree tree, DrawnCrownLine line)
{
    constexpr double kInSheet_deg = 8;
    auto const points = TRY(crown_line_of(line.stroke));
    if (TRY(kind_of(points)) == CrownLineKind::Side
        && std::fabs(90 - azimuth_deg(points)) > 90 - kInSheet_deg) {
        tree.outline = std::move(line.stroke);
        return tree;
    }
    std::vector<DrawnCrownLine> kept;
    for (auto& other : tree.crown_lines)
        if (!takes_place_of(points, TRY(crown_line_of(other.stroke))))
            kept.push_back(std::move(other));
    kept.push_back(std::move(line));
    tree.crown_lines = std::move(kept);
    return tree;
}

Result<std::optional<scene::ItemId>> outline_around(OutlinedTree const& tree, Stroke const& stroke)
{
    auto const place = TRY(middle_of(stroke));
    std::optional<scene::ItemId> smallest;
    double least = 1e300;
    auto const look_at = [&](std::vector<Vec2> const& outline, scene::ItemId id) {
        double const area = outline.size() < 3 ? 0 : std::fabs(signed_area(outline));
        if (area >= least || outline.size() < 3 || !is_inside(outline, place))
            return;
        least = area;
        smallest = id;
    };
    if (auto const drawing = TRY(drawing_of(tree)); !drawing.outline.empty())
        look_at(drawing.outline.front(), 0);
    for (auto const& own : tree.own_outlines)
        look_at(TRY(line_of(own.stroke)), own.id);
    return smallest;
}

Result<std::size_t> count_without_effect(OutlinedTree const& tree)
{
    if (!tree.is_refined() && tree.styles.empty() && tree.touches.empty())
        return 0;
    if (!tree.has_crown())
        return tree.own_outlines.size() + tree.own_branches.size() + tree.styles.size()
            + tree.touches.size();
    auto const drawing = TRY(drawing_of(tree));
    auto const skeleton = TRY(skeleton_of(tree));
    std::size_t count = count_unmatched_touches(drawing, skeleton);
    for (auto const& own : tree.own_outlines)
        count += !skeleton.at(own.branch);
    for (auto const& own : tree.own_branches) {
        auto const at = skeleton.at(own.branch);
        count += !at || skeleton.systems[at->system].branches[at->branch].leaf;
    }
    for (auto const& [target, source] : tree.styles)
        count += !skeleton.at(target) || !skeleton.at(source);
    return count;
}

// Copies the assignment of lines to branches from the drawing to the tree.
static void place_lines(OutlinedTree& tree, Drawing const& drawing)
{
    for (std::size_t i = 0; i < tree.own_outlines.size(); ++i)
        tree.own_outlines[i].branch = drawing.own_outlines[i].branch;
    for (std::size_t i = 0; i < tree.own_branches.size(); ++i)
        tree.own_branches[i].branch = drawing.own_branches[i].branch;
    for (std::size_t i = 0; i < tree.touches.size(); ++i)
        tree.touches[i].branch = drawing.touches[i].branch;
    tree.styles = drawing.styles;
}

Result<void> keep_names(OutlinedTree const& before, OutlinedTree& after, std::string const& fresh)
{
    if (!after.has_crown())
        return {};
    auto drawing = TRY(drawing_of(after));
    if (!before.has_crown()) {
        if (!after.is_refined())
            return {};
        ReassigningNamer again;
        TRY(infer_skeleton(drawing, options_of(after), again));
        place_lines(after, drawing);
        return {};
    }
    auto const earlier = TRY(inferred(before));
    auto renamed = TRY(kept_names(*earlier, drawing, options_of(after), fresh));
    after.names = std::move(renamed.names);
    place_lines(after, drawing);
    if (after.inferred && renamed.inferred)
        after.inferred->keep(after,
                             std::make_shared<InferredDrawing const>(*std::move(renamed.inferred)));
    return {};
}

} // namespace tractus::silhouette
