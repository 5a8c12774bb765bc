#include "app/methods/silhouettes/outline_meaning.h"

#include "app/methods/silhouettes/touched_crown.h"
#include "engine/methods/silhouettes/nearest_style.h"
#include "engine/methods/silhouettes/trunk_reach.h"
#include "engine/scene/paper.h"
#include "engine/scene/picture_ground.h"
#include "engine/stroke/foot_first.h"
#include "engine/stroke/upright_sheet.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace tractus::silhouette {

namespace {

using Part = DrawTree::Part;
using What = OutlineTool::What;

std::vector<Vec2> points_of(Stroke const& stroke)
{
    std::vector<Vec2> points;
    for (auto const& tip : stroke.tips)
        points.emplace_back(tip.position_mm.head<2>());
    return points;
}

bool has_any_inside(std::vector<Vec2> const& outline, std::vector<Vec2> const& points)
{
    return std::any_of(points.begin(), points.end(),
                       [&](Vec2 const& point) { return is_inside(outline, point); });
}

// True if the outline `points` belongs to the tree: it overlaps the crown or, if there is no crown
// yet, contains a part of the trunk or (since Reads::Closely) is just above the trunk.
bool is_around(std::vector<Vec2> const& points, Drawing const& tree, OutlineTool::Reads reads)
{
    if (tree.outline.empty())
        return has_any_inside(points, tree.trunk)
            || (reads >= OutlineTool::Reads::Closely && extension_into_crown(tree.trunk, points));
    auto const& crown = tree.outline.front();
    return is_inside(crown, box_of(points).middle()) || is_inside(points, box_of(crown).middle());
}

// True if the line comes from below the crown and the crown has no trunk yet, so that the line is
// its trunk.
bool is_trunk_of_crown(Drawing const& tree, std::vector<Vec2> const& points)
{
    if (!tree.trunk.empty() || tree.outline.empty())
        return false;
    auto const& crown = tree.outline.front();
    bool const begins_below
        = points.front().y() < box_of(crown).middle().y() && !is_inside(crown, points.front());
    return begins_below && (is_inside(crown, points.back()) || extension_into_crown(points, crown));
}

// Largest gap at which two lines count as touching, in millimetres.
double touching_mm(Drawing const& tree)
{
    // As a share of the diagonal of the drawing's bounding box.
    constexpr double kNear = 0.08;
    auto all = tree.trunk;
    if (!tree.outline.empty())
        all.insert(all.end(), tree.outline[0].begin(), tree.outline[0].end());
    return kNear * box_of(all).diagonal();
}

// The part of a tree's drawing that an open line is; no value if the line does not belong to the
// tree.
std::optional<Part> part_on(Drawing const& tree, Vec2 const& foot, std::vector<Vec2> const& points)
{
    double const near_mm = touching_mm(tree);
    if ((points.front() - foot).norm() <= near_mm)
        return Part::Trunk;
    if (tree.outline.empty())
        return std::nullopt;
    bool const is_on_trunk
        = !tree.trunk.empty() && distance_to_line(points.front(), tree.trunk) <= near_mm;
    if (is_on_trunk || is_inside(tree.outline[0], points.front()))
        return Part::Branch;
    return std::nullopt;
}

// True if a stroke is so short that it counts as a touch of the pen.
bool is_touch(std::vector<Vec2> const& points)
{
    constexpr double kLongest_mm = 4;
    return points.size() < 2 || box_of(points).diagonal() <= kLongest_mm;
}

Search search_of(OutlineTool::Branches branches)
{
    return branches == OutlineTool::Branches::OfAny ? Search::AnyLevel : Search::OnTrunk;
}

Result<std::optional<Part>> part_of_tree(OutlinedTree const& tree, Stroke const& stroke,
                                         OutlineTool const& tool)
{
    auto const branches = tool.branches;
    auto const search = search_of(branches);
    auto const points = points_of(stroke);
    auto const drawing = TRY(drawing_of(tree));
    if (!is_closed_stroke(points)) {
        auto part = part_on(drawing, TRY(foot_of(tree)), points);
        if (!part && tool.reads >= OutlineTool::Reads::Closely
            && is_trunk_of_crown(drawing, points))
            part = Part::Trunk;
        bool const may_be_borne = branches != OutlineTool::Branches::OfTrunk && part != Part::Trunk;
        if (may_be_borne && TRY(parent_of_drawn_branch(tree, stroke, search)))
            return Part::OwnBranch;
        return part;
    }
    if (TRY(branch_outlined_by(tree, stroke, search)))
        return Part::OwnOutline;
    return is_around(points, drawing, tool.reads) ? std::optional(Part::Outline) : std::nullopt;
}

// True if an open line was drawn from tip to foot: it ends where the tree's trunk stands, comes
// down from the crown that has no trunk yet, or ends on the trunk that is to bear it.
bool is_from_tip(Drawing const& tree, Vec2 const& foot, std::vector<Vec2> const& points)
{
    auto const near_mm = touching_mm(tree);
    auto const reversed = std::vector(points.rbegin(), points.rend());
    if (tree.trunk.empty())
        return !is_trunk_of_crown(tree, points) && is_trunk_of_crown(tree, reversed);
    bool const redraws_trunk
        = (points.back() - foot).norm() <= near_mm && (points.front() - foot).norm() > 2 * near_mm;
    if (redraws_trunk)
        return true;
    auto const off = [&](Vec2 const& place) { return distance_to_line(place, tree.trunk); };
    return !tree.outline.empty() && off(points.back()) <= near_mm / 2
        && off(points.front()) > 2 * near_mm && is_inside(tree.outline[0], points.back());
}

// True if the tool's stroke is an open line that was drawn from tip to foot: one of the tree, or
// the trunk of a new tree.
Result<bool> is_drawn_from_tip(OutlineTool const& tool, Stroke const& stroke,
                               scene::Scene const& scene)
{
    auto const points = points_of(stroke);
    if (is_touch(points) || is_closed_stroke(points))
        return false;
    auto const* const tree = outlined_tree(*scene.drawn);
    if (tree && tool.what != What::New) {
        if (is_from_tip(TRY(drawing_of(*tree)), TRY(foot_of(*tree)), points))
            return true;
        if (TRY(part_of_tree(*tree, stroke, tool)))
            return false;
    }
    return is_drawn_to_foot(plant_tips(stroke.tips.vector(), StrokeSurface::Paper), {});
}

// Length in millimetres by which the trunk is continued into the crown after a line with the role
// `part` has been drawn. For a crown that the trunk does not reach, the tree's previous length.
Result<double> trunk_reach(OutlinedTree tree, Part part, std::vector<Vec2> const& points)
{
    if (part != Part::Trunk && part != Part::Outline)
        return 0;
    double const before_mm = std::exchange(tree.trunk_goes_on_mm, 0);
    auto const drawing = TRY(drawing_of(tree));
    if (part == Part::Trunk)
        return drawing.outline.empty()
            ? 0
            : extension_into_crown(points, drawing.outline.front()).value_or(0);
    return has_any_inside(points, drawing.trunk)
        ? 0
        : extension_into_crown(drawing.trunk, points).value_or(before_mm);
}

// The drawing of the outline with this id on a branch; null if the id is the crown's or unknown.
DrawnOnBranch const* outline_of(OutlinedTree const& tree, scene::ItemId id)
{
    auto const found
        = std::find_if(tree.own_outlines.begin(), tree.own_outlines.end(),
                       [&](DrawnOnBranch const& own) { return own.id == id && id != 0; });
    return found == tree.own_outlines.end() ? nullptr : &*found;
}

// The edit that revokes the declaration of a leaf. If the leaf's outline was taken from a bump, the
// outline is erased.
scene::Edit no_leaf_any_more(scene::ItemId plant, DrawnOnBranch const& leaf)
{
    if (leaf.of_bump)
        return EraseTreePart { plant, Part::OwnOutline, leaf.id };
    return DeclareLeaf { plant, leaf.id, false };
}

// Makes a stroke along the outline with the height, pressure and other pen data of the touch.
Stroke stroke_around(std::vector<Vec2> const& outline, Stroke const& touch)
{
    constexpr auto kStep = Duration(5'000'000);
    auto tip = *touch.tips.begin();
    std::vector<TipSample> tips;
    for (std::size_t i = 0; i <= outline.size(); ++i) {
        tip.position_mm.head<2>() = outline[i % outline.size()];
        tips.push_back(tip);
        tip.time += kStep;
    }
    return { std::move(tips) };
}

// The edit for a touch on a bump: the branch that ends in the bump becomes a leaf, or stops being a
// leaf.
Result<scene::Edit> declared_on(BumpLeaf const& bump, OutlineTool const& tool, Stroke const& touch,
                                scene::Scene const& scene)
{
    auto const& tree = *outlined_tree(*scene.drawn);
    auto const plant = scene.drawn->id;
    for (auto const& own : tree.own_outlines)
        if (own.branch == bump.branch)
            return own.is_leaf ? no_leaf_any_more(plant, own)
                               : scene::Edit(DeclareLeaf { plant, own.id, true });
    auto const search = search_of(tool.branches);
    auto stroke = stroke_around(bump.outline, touch);
    if (TRY(branch_outlined_by(tree, stroke, search)) != bump.branch)
        return fail(Fault::User,
                    "the bump is too large a part of the crown to be a leaf of it: draw around the "
                    "leaf, back to where you began");
    return DrawTree { .part = Part::OwnOutline,
                      .stroke = std::move(stroke),
                      .is_leaf = true,
                      .of_bump = true,
                      .style_to = tool.style,
                      .search = search,
                      .plant = plant };
}

// Gives a new tree its true size and places it on the ground of the picture behind the drawing.
void stand_on_ground(DrawTree& edit, scene::GroundPlace const& place, scene::Scene const& scene)
{
    constexpr double kMetre_mm = 1000; // Millimetres of a plant per metre.
    edit.scale = 1 / (kMetre_mm * place.m_per_mm);
    double const scale = scene.plants.empty() ? edit.scale : scene.placement.scale;
    edit.enlarged = scale / edit.scale;
    edit.stands_at_mm = scale * kMetre_mm * Vec3(place.right_m, place.behind_m, 0);
    edit.stands_at_mm.x() += scene.state.picture->place.x_mm;
}

// Makes a new tree take the style of the nearest tree, unless the user chose a form or numbers.
void take_nearest_style(DrawTree& edit, OutlineTool const& tool, scene::Scene const& scene)
{
    if (tool.reads < OutlineTool::Reads::Closely || !is_usual(edit.form))
        return;
    edit.takes_style = true;
    auto const source = nearest_with_style(scene.state, edit.stands_at_mm, 0);
    auto const built = std::find_if(scene.plants.begin(), scene.plants.end(),
                                    [&](auto const& plant) { return plant->drawn->id == source; });
    if (source == 0 || built == scene.plants.end())
        return;
    if (auto const form = with_style_of(edit.form, *(*built)->base))
        edit.form = *form;
}

} // namespace

Result<OutlinedTree const*> active_tree(scene::Scene const& scene)
{
    auto const* const tree = outlined_tree(*scene.drawn);
    if (!tree)
        return fail(Fault::User,
                    "the plant that takes what is drawn has no outline: choose a tree that was "
                    "drawn by its outline, or draw one");
    return tree;
}

Result<DrawTree> drawn_tree(OutlineTool const& tool, Stroke const& stroke,
                            scene::Scene const& scene)
{
    if (tool.what == What::Split || tool.what == What::Join) {
        TRY(active_tree(scene));
        return DrawTree { .part = tool.what == What::Split ? Part::Split : Part::Join,
                          .stroke = stroke,
                          .search = search_of(tool.branches),
                          .plant = scene.drawn->id };
    }
    auto const points = points_of(stroke);
    bool const may_be_of_picture = tool.what == What::GoOn || tool.what == What::New;
    if (may_be_of_picture && scene.state.picture && is_touch(points))
        return drawn_tree(tool, TRY(outline_touched(*scene.state.picture, stroke)), scene);
    if (points.size() < 2)
        return fail(Fault::User,
                    "a dot is no part of a tree: draw its trunk, or the outline of its crown");
    if (tool.reads >= OutlineTool::Reads::FootFirst
        && TRY(is_drawn_from_tip(tool, stroke, scene))) {
        auto as_drawn = tool;
        as_drawn.reads = OutlineTool::Reads::Closely;
        auto turned = TRY(drawn_tree(as_drawn, turned_round(stroke), scene));
        turned.is_drawn_reversed = true;
        return turned;
    }
    DrawTree edit { .stroke = stroke, .is_leaf = tool.what == What::Leaf };
    auto const* const tree = outlined_tree(*scene.drawn);
    if (tree && tool.what != What::New)
        if (auto const part = TRY(part_of_tree(*tree, stroke, tool))) {
            edit.part = *part;
            if (*part == Part::OwnOutline || *part == Part::OwnBranch) {
                edit.style_to = tool.style;
                edit.search = search_of(tool.branches);
            }
            if (tool.reads >= OutlineTool::Reads::Closely)
                edit.trunk_goes_on_mm = TRY(trunk_reach(*tree, *part, points));
            edit.plant = scene.drawn->id;
            return edit;
        }
    edit.part = is_closed_stroke(points) ? Part::Outline : Part::Trunk;
    edit.form = form_of(tool, {});
    if (!scene.plants.empty())
        edit.scale = scene.placement.scale;
    auto const tree_drawn = TRY(tree_with(edit, scene));
    auto const foot_mm = TRY(foot_of(tree_drawn));
    edit.stands_at_mm = scene::paper_of(scene.state).world_of_sheet(foot_mm);
    edit.stands_at_mm.z() = 0;
    if (scene.state.picture)
        if (auto const place = TRY(scene::place_on_ground(*scene.state.picture, foot_mm)))
            stand_on_ground(edit, *place, scene);
    take_nearest_style(edit, tool, scene);
    return edit;
}

Result<std::optional<scene::Edit>> declared_leaf(OutlineTool const& tool, Stroke const& stroke,
                                                 scene::Scene const& scene)
{
    auto const points = points_of(stroke);
    if (!is_touch(points) && is_closed_stroke(points))
        return std::nullopt;
    auto const* const tree = TRY(active_tree(scene));
    auto const id = TRY(outline_around(*tree, stroke));
    auto const* const around = id ? outline_of(*tree, *id) : nullptr;
    if (around && around->is_leaf)
        return no_leaf_any_more(scene.drawn->id, *around);
    if (tool.reads >= OutlineTool::Reads::Closely && tree->has_crown() && !tree->is_leaf)
        if (auto const on_bump = TRY(leaf_on_bump(*tree, stroke, search_of(tool.branches))))
            return TRY(declared_on(*on_bump, tool, stroke, scene));
    if (!id)
        return fail(Fault::User,
                    "the touch lies in no outline of the tree: touch inside one, or draw around "
                    "the leaf, back to where you began");
    return DeclareLeaf { scene.drawn->id, *id, !(tree->is_leaf && *id == 0) };
}

Result<ChooseStyles> copied_styles(Stroke const& stroke, scene::Scene const& scene)
{
    auto const* const tree = TRY(active_tree(scene));
    return ChooseStyles { scene.drawn->id, TRY(styles_copied_by(*tree, stroke)) };
}

Result<std::vector<scene::Edit>> turned_line(OutlineTool const& tool, Stroke const& touch,
                                             scene::Scene const& scene)
{
    constexpr double kNear_mm = 6;
    auto const* const tree = TRY(active_tree(scene));
    auto as_drawn = *tree;
    as_drawn.trunk_goes_on_mm = 0;
    auto const drawing = TRY(drawing_of(as_drawn));
    auto const points = points_of(touch);
    double nearest_mm = kNear_mm;
    Stroke const* line = nullptr;
    std::optional<EraseTreePart> erased;
    auto const look_at = [&](std::vector<Vec2> const& at, Stroke const& drawn,
                             std::optional<EraseTreePart> const& erase) {
        if (points.empty() || at.empty() || distance_to_line(points.back(), at) > nearest_mm)
            return;
        nearest_mm = distance_to_line(points.back(), at);
        line = &drawn;
        erased = erase;
    };
    auto const plant = scene.drawn->id;
    look_at(drawing.trunk, tree->trunk, std::nullopt);
    for (std::size_t i = 0; i < tree->branches.size(); ++i)
        look_at(drawing.branches[i], tree->branches[i].stroke,
                EraseTreePart { plant, Part::Branch, tree->branches[i].id });
    for (std::size_t i = 0; i < tree->own_branches.size(); ++i)
        look_at(drawing.own_branches[i].line, tree->own_branches[i].stroke,
                EraseTreePart { plant, Part::OwnBranch, tree->own_branches[i].id });
    if (!line)
        return fail(Fault::User,
                    "there is no trunk or branch of the tree's drawing here: touch one");
    if (!erased)
        return std::vector<scene::Edit> { DrawTree {
            .part = Part::Trunk, .stroke = turned_round(*line), .plant = plant } };
    auto reading = tool;
    reading.what = What::GoOn;
    reading.reads = OutlineTool::Reads::Closely;
    auto const without = TRY(scene::apply_edit(scene, *erased));
    return std::vector<scene::Edit> { *erased,
                                      TRY(drawn_tree(reading, turned_round(*line), without)) };
}

Result<OutlinedTree> tree_with(DrawTree const& edit, scene::Scene const& scene)
{
    if (edit.plant != 0)
        return with_part(*outlined_tree(*scene.drawn), edit);
    return with_part({ .form = edit.form, .scale = edit.scale }, edit);
}

} // namespace tractus::silhouette
