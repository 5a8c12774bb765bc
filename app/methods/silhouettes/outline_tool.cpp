#include "app/methods/silhouettes/outline_tool.h"

#include "app/methods/silhouettes/erase_outline_tool.h"
#include "app/methods/silhouettes/outline_previewer.h"
#include "app/methods/silhouettes/touched_crown.h"
#include "engine/methods/silhouettes/ready_form.h"
#include "engine/scene/paper.h"
#include "engine/scene/picture_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::silhouette {

namespace {

using silhouette::DrawTree;
using silhouette::OutlinedTree;
using Part = silhouette::DrawTree::Part;
using What = OutlineTool::What;

// In the order of What.
constexpr std::array<tools::OptionWord, 8> kWords { {
    { "go_on", "Go on" },
    { "new", "New tree" },
    { "carry", "Carry a style" },
    { "split", "Split a bump", "Touch a bump to split it" },
    { "join", "Join bumps", "Touch between two bumps to join them" },
    { "leaf", "Leaf", "Outline a leaf, or touch an outline" },
    { "form", "To this tree", nullptr, true },
    { "reseed", "Another one", nullptr, true },
} };

// In the order of OutlineTool::Form: the usual one, then the ready ones.
constexpr std::array<tools::OptionWord, 6> kFormWords { {
    { "usual", "Usual" },
    { "oak", "Oak" },
    { "pine", "Pine" },
    { "willow", "Willow" },
    { "eucalyptus", "Eucalyptus" },
    { "fir", "Fir" },
} };

// In the order of OutlineTool::Branches.
constexpr std::array<tools::OptionWord, 3> kBranchesWords { {
    { "of_trunk", "of the trunk" },
    { "of_nearest", "of its branches" },
    { "of_any", "of what they begin on" },
} };

// In the order of silhouette::StyleTo.
constexpr std::array<tools::OptionWord, 3> kStyleWords { {
    { "none", "of one branch" },
    { "siblings", "to its siblings" },
    { "deeper", "to siblings and below" },
} };

// In the order of OutlineTool::SeenFor.
constexpr std::array<tools::OptionWord, 3> kSeenWords { {
    { "seen_fades", "fades" },
    { "seen_stays", "stays" },
    { "with_triangles", "stays, with triangles" },
} };

silhouette::TreeForm ready_form(OutlineTool const& tool)
{
    if (tool.form == OutlineTool::Form::Usual)
        return {};
    return silhouette::ready_forms()[static_cast<std::size_t>(tool.form) - 1].form;
}

void take_numbers_of_form(void* options)
{
    auto& tool = *static_cast<OutlineTool*>(options);
    auto const form = ready_form(tool);
    tool.levels = form.levels;
    tool.density = form.density;
    tool.leaves = form.leaves;
}

void visit(tools::OptionVisitor& visitor, OutlineTool& tool)
{
    visitor.choice({ .words = kFormWords,
                     .offered = tools::WordOption::Offered::Cards,
                     .goes_with = take_numbers_of_form,
                     .label = "Form" },
                   tool.form);
    visitor.number({ "levels", "", 1, 3, 1, "Orders" }, tool.levels);
    visitor.number({ "density", "", 0, 10, 0.25, "Density" }, tool.density);
    visitor.number({ "leaves", "", 1, 500, 4, "Leaves" }, tool.leaves);
    visitor.choice({ kWords }, tool.what);
    visitor.choice({ .words = kBranchesWords,
                     .offered = tools::WordOption::Offered::InTurn,
                     .label = "Lines" },
                   tool.branches);
    visitor.choice(
        { .words = kStyleWords, .offered = tools::WordOption::Offered::InTurn, .label = "Style" },
        tool.style);
    visitor.choice({ .words = kSeenWords,
                     .offered = tools::WordOption::Offered::InTurn,
                     .label = "What is seen" },
                   tool.seen);
}

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
                       [&](Vec2 const& point) { return silhouette::is_inside(outline, point); });
}

// Whether an outline is another one of a tree's crown: they lie on each other.
bool is_around(std::vector<Vec2> const& points, silhouette::Drawing const& tree)
{
    if (tree.outline.empty())
        return has_any_inside(points, tree.trunk);
    auto const& crown = tree.outline.front();
    return silhouette::is_inside(crown, silhouette::box_of(points).middle())
        || silhouette::is_inside(points, silhouette::box_of(crown).middle());
}

// What a line that does not come back is to a tree; no value: nothing.
std::optional<Part> part_on(silhouette::Drawing const& tree, Vec2 const& foot,
                            std::vector<Vec2> const& points)
{
    constexpr double kNear = 0.08; // Of the drawing's diagonal.
    auto all = tree.trunk;
    if (!tree.outline.empty())
        all.insert(all.end(), tree.outline[0].begin(), tree.outline[0].end());
    double const near_mm = kNear * silhouette::box_of(all).diagonal();
    if ((points.front() - foot).norm() <= near_mm)
        return Part::Trunk;
    if (tree.outline.empty())
        return std::nullopt;
    bool const is_on_trunk = !tree.trunk.empty()
        && silhouette::distance_to_line(points.front(), tree.trunk) <= near_mm;
    if (is_on_trunk || silhouette::is_inside(tree.outline[0], points.front()))
        return Part::Branch;
    return std::nullopt;
}

// A stroke that is no line: the pen touched the paper.
bool is_touch(std::vector<Vec2> const& points)
{
    constexpr double kLongest_mm = 4;
    return points.size() < 2 || silhouette::box_of(points).diagonal() <= kLongest_mm;
}

silhouette::Search search_of(OutlineTool::Branches branches)
{
    return branches == OutlineTool::Branches::OfAny ? silhouette::Search::AnyLevel
                                                    : silhouette::Search::OnTrunk;
}

Result<std::optional<Part>> part_of_tree(OutlinedTree const& tree, Stroke const& stroke,
                                         OutlineTool::Branches branches)
{
    auto const search = search_of(branches);
    auto const points = points_of(stroke);
    auto const drawing = TRY(silhouette::drawing_of(tree));
    if (!silhouette::comes_back(points)) {
        auto const part = part_on(drawing, TRY(silhouette::foot_of(tree)), points);
        bool const may_be_borne = branches != OutlineTool::Branches::OfTrunk && part != Part::Trunk;
        if (may_be_borne && TRY(silhouette::branch_borne_by(tree, stroke, search)))
            return Part::OwnBranch;
        return part;
    }
    if (TRY(silhouette::branch_outlined_by(tree, stroke, search)))
        return Part::OwnOutline;
    return is_around(points, drawing) ? std::optional(Part::Outline) : std::nullopt;
}

silhouette::TreeForm form_of(OutlineTool const& tool, silhouette::TreeForm form)
{
    form.levels = static_cast<int>(std::lround(tool.levels));
    form.density = tool.density;
    form.leaves = static_cast<int>(std::lround(tool.leaves));
    if (tool.form != OutlineTool::Form::Usual) {
        auto const ready = ready_form(tool);
        form.patterns = ready.patterns;
        form.leaf_width = ready.leaf_width;
        form.styles = ready.styles;
    }
    return form;
}

// The tree that takes what is drawn.
Result<OutlinedTree const*> active_tree(scene::Scene const& scene)
{
    auto const* const tree = silhouette::outlined_tree(*scene.drawn);
    if (!tree)
        return fail(Fault::User,
                    "the plant that takes what is drawn has no outline: choose a tree that was "
                    "drawn by its outline, or draw one");
    return tree;
}

Result<std::vector<scene::Edit>> form_active(OutlineTool const& tool, scene::Scene const& scene)
{
    auto const* const tree = TRY(active_tree(scene));
    auto form = tree->form;
    if (tool.what == What::Reseed)
        ++form.seed;
    else
        form = form_of(tool, form);
    return std::vector<scene::Edit> { silhouette::FormTree { scene.drawn->id, form } };
}

// As large as it is in truth, and where it stands among the others, all in the scale of the first.
void stand_on_ground(DrawTree& edit, scene::GroundPlace const& place, scene::Scene const& scene)
{
    constexpr double kMetre_mm = 1000; // Of a plant's millimetres.
    edit.scale = 1 / (kMetre_mm * place.m_per_mm);
    double const scale = scene.plants.empty() ? edit.scale : scene.placement.scale;
    edit.enlarged = scale / edit.scale;
    edit.stands_at_mm = scale * kMetre_mm * Vec3(place.right_m, place.behind_m, 0);
    edit.stands_at_mm.x() += scene.state.picture->place.x_mm;
}

std::string counted_branches(std::size_t count)
{
    return fmt::format("{} {}", count, count == 1 ? "branch" : "branches");
}

silhouette::DrawnOnBranch const* drawn_by(std::vector<silhouette::DrawnOnBranch> const& drawn,
                                          std::uint64_t edit)
{
    auto const found
        = std::find_if(drawn.begin(), drawn.end(), [&](silhouette::DrawnOnBranch const& one) {
              return scene::edit_of_item(one.id) == edit;
          });
    return found == drawn.end() ? nullptr : &*found;
}

// How many branches the branch of this path bears; no value: there is none.
std::optional<std::size_t> count_on(OutlinedTree on_trunk, std::string const& path)
{
    on_trunk.form.levels = 1;
    auto const skeleton = silhouette::skeleton_of(on_trunk);
    if (!skeleton)
        return std::nullopt;
    auto const parent = skeleton->at(path);
    return parent ? std::optional(skeleton->branches_on(*parent)) : std::nullopt;
}

// What is said of the branch that was drawn on last; empty: another line was drawn.
std::string said_of_branch(OutlinedTree const& tree, std::uint64_t last_edit)
{
    auto const* const own = drawn_by(tree.own_outlines, last_edit);
    auto const* const drawn = own ? own : drawn_by(tree.own_branches, last_edit);
    if (!drawn)
        return {};
    constexpr std::array kFollow { "", "; its siblings follow",
                                   "; its siblings follow, and what is below" };
    auto const* const follow = kFollow[static_cast<std::size_t>(drawn->style_to)];
    if (own && own->is_leaf)
        return fmt::format("The branch ends in the leaf{}", follow);
    if (!own)
        return fmt::format("The branch bears {} that you drew{}",
                           counted_branches(static_cast<std::size_t>(std::count_if(
                               tree.own_branches.begin(), tree.own_branches.end(),
                               [&](auto const& other) { return other.branch == drawn->branch; }))),
                           follow);
    auto const count = count_on(tree, own->branch);
    return count ? fmt::format("The branch has its own outline: {} in it{}",
                               counted_branches(*count), follow)
                 : std::string();
}

// What was drawn on branches that the tree has lost.
std::string said_of_waiting(OutlinedTree const& tree)
{
    auto const waiting = silhouette::count_waiting(tree);
    if (!waiting || *waiting == 0)
        return {};
    return *waiting == 1
        ? "; a line that was drawn on a branch waits for it"
        : fmt::format("; {} lines that were drawn on branches wait for them", *waiting);
}

// How many branches have a style that somebody chose.
std::string said_of_styles(OutlinedTree const& tree)
{
    return tree.styles.empty()
        ? std::string("Each branch has its own style, or that of all")
        : fmt::format("{} the style of another one{}",
                      tree.styles.size() == 1 ? "1 branch has"
                                              : fmt::format("{} branches have", tree.styles.size()),
                      said_of_waiting(tree));
}

// What the tree has now, and what it still wants.
std::string said_of_tree(tools::Tool const& tool, scene::Scene const& after)
{
    auto const* const tree = silhouette::outlined_tree(*after.drawn);
    if (!tree)
        return {};
    if (!tree->has_crown())
        return "A trunk stands: draw the outline of its crown around it, back to where you began";
    if (tree->is_leaf)
        return "The crown is a leaf: touch it once more as a leaf, and it has branches again";
    if (tool.get<OutlineTool>()->what == What::Carry)
        return said_of_styles(*tree);
    if (auto said = said_of_branch(*tree, after.state.last_edit); !said.empty())
        return said;
    auto const& axes = after.base->axes;
    auto const on_trunk
        = std::count_if(axes.begin(), axes.end(), [](Axis const& axis) { return axis.order == 1; });
    return fmt::format("The tree has {} branches on its trunk, {} in all{}", on_trunk,
                       axes.size() - 1, said_of_waiting(*tree));
}

Result<std::vector<scene::Edit>> draw(tools::Tool const& tool, Stroke const& stroke,
                                      scene::Scene const& scene)
{
    auto const& options = *tool.get<OutlineTool>();
    if (options.what == What::Form || options.what == What::Reseed)
        return form_active(options, scene);
    if (options.what == What::Carry)
        return std::vector<scene::Edit> { TRY(carried_styles(stroke, scene)) };
    if (options.what == What::Leaf)
        if (auto const declared = TRY(declared_leaf(stroke, scene)))
            return std::vector<scene::Edit> { *declared };
    return std::vector<scene::Edit> { TRY(drawn_tree(options, stroke, scene)) };
}

} // namespace

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
    DrawTree edit { .stroke = stroke, .is_leaf = tool.what == What::Leaf };
    auto const* const tree = silhouette::outlined_tree(*scene.drawn);
    if (tree && tool.what != What::New)
        if (auto const part = TRY(part_of_tree(*tree, stroke, tool.branches))) {
            edit.part = *part;
            if (*part == Part::OwnOutline || *part == Part::OwnBranch) {
                edit.style_to = tool.style;
                edit.search = search_of(tool.branches);
            }
            edit.plant = scene.drawn->id;
            return edit;
        }
    edit.part = silhouette::comes_back(points) ? Part::Outline : Part::Trunk;
    edit.form = form_of(tool, {});
    if (!scene.plants.empty())
        edit.scale = scene.placement.scale;
    auto const tree_drawn = TRY(tree_with(edit, scene));
    auto const foot_mm = TRY(silhouette::foot_of(tree_drawn));
    edit.stands_at_mm = scene::paper_of(scene.state).world_of_sheet(foot_mm);
    edit.stands_at_mm.z() = 0;
    if (scene.state.picture)
        if (auto const place = TRY(scene::place_on_ground(*scene.state.picture, foot_mm)))
            stand_on_ground(edit, *place, scene);
    return edit;
}

Result<std::optional<silhouette::DeclareLeaf>> declared_leaf(Stroke const& stroke,
                                                             scene::Scene const& scene)
{
    auto const points = points_of(stroke);
    if (!is_touch(points) && silhouette::comes_back(points))
        return std::nullopt;
    auto const* const tree = TRY(active_tree(scene));
    auto const id = TRY(silhouette::outline_around(*tree, stroke));
    if (!id)
        return fail(Fault::User,
                    "the touch lies in no outline of the tree: touch inside one, or draw around "
                    "the leaf, back to where you began");
    bool is_leaf = tree->is_leaf && *id == 0;
    for (auto const& own : tree->own_outlines)
        is_leaf = is_leaf || (own.id == *id && own.is_leaf);
    return silhouette::DeclareLeaf { scene.drawn->id, *id, !is_leaf };
}

Result<silhouette::ChooseStyles> carried_styles(Stroke const& stroke, scene::Scene const& scene)
{
    auto const* const tree = TRY(active_tree(scene));
    return silhouette::ChooseStyles { scene.drawn->id,
                                      TRY(silhouette::styles_carried_by(*tree, stroke)) };
}

Result<OutlinedTree> tree_with(DrawTree const& edit, scene::Scene const& scene)
{
    if (edit.plant != 0)
        return silhouette::with_part(*silhouette::outlined_tree(*scene.drawn), edit);
    return silhouette::with_part({ .form = edit.form, .scale = edit.scale }, edit);
}

constexpr tools::ToolKind OutlineTool::kKind {
    .word = "outline",
    .label = "Outline",
    .title = "A trunk, and the outline of its crown",
    .done = "The tree has what was drawn",
    .help
    = "draws a tree on paper that stands upright: a line is a trunk, one that comes back to "
      "its beginning the outline of a crown, a smaller one around a branch that branch's "
      "own outline, a line from a trunk inside it a branch, and one from a branch a branch "
      "of that if lines are of what they begin on; what is drawn on a branch may be a style "
      "for its siblings, or a line carries a branch's style to those that it runs over; a "
      "touch on a bump of an outline splits it in two, one between two bumps joins them, and "
      "an outline may be a leaf, which a touch inside declares it or takes back; a touch on a "
      "crown in the picture behind is its outline; in a ready form, or with so many levels of "
      "branches, so many times "
      "as many as usual that nobody draws, so many leaves on a twig; a new tree at each "
      "line, or at once these numbers, or other chance, for the tree that is there",
    .group = "Sketch",
    .method = "From an outline",
    .icon = "5954 371624416184866737",
    .key = 'O',
    .surface = tools::Surface::Paper,
    .options = tools::options_type<OutlineTool, visit>(),
    .mean = draw,
    .said = said_of_tree,
    .previewer = outline_previewer,
    .other_end = { &EraseOutlineTool::kKind },
};

} // namespace tractus::silhouette
