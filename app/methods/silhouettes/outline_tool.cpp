#include "app/methods/silhouettes/outline_tool.h"

#include "app/methods/silhouettes/describe_tree.h"
#include "app/methods/silhouettes/erase_outline_tool.h"
#include "app/methods/silhouettes/outline_meaning.h"
#include "app/methods/silhouettes/outline_previewer.h"
#include "engine/methods/silhouettes/outlined_tree.h"
#include "engine/methods/silhouettes/tree_preset.h"

#include <array>
#include <cmath>

namespace tractus::silhouette {

namespace {

using What = OutlineTool::What;

// Option words, in the order of the enumeration What.
constexpr std::array<tools::OptionWord, 9> kWords { {
    { "go_on", "Go on" },
    { "new", "New tree" },
    { "carry", "Carry a style" },
    { "split", "Split a bump", "Touch a bump to split it" },
    { "join", "Join bumps", "Touch between two bumps to join them" },
    { "leaf", "Leaf", "Outline a leaf, or touch a bump or an outline" },
    { "turned", "Turn round", "Touch a trunk or branch to turn it round" },
    { "form", "To this tree", nullptr, true },
    { "reseed", "Another one", nullptr, true },
} };

// Option words, in the order of OutlineTool::Form: Usual, then the presets.
constexpr std::array<tools::OptionWord, 12> kFormWords { {
    { "usual", "Usual" },
    { "oak", "Oak" },
    { "pine", "Pine" },
    { "willow", "Willow" },
    { "eucalyptus", "Eucalyptus" },
    { "fir", "Fir" },
    { "poplar", "Poplar" },
    { "fern", "Fern" },
    { "umbrella_pine", "Umbrella pine" },
    { "baobab", "Baobab" },
    { "acacia", "Acacia" },
    { "birch", "Birch" },
} };

// Option words, in the order of OutlineTool::Branches.
constexpr std::array<tools::OptionWord, 3> kBranchesWords { {
    { "of_trunk", "of the trunk" },
    { "of_nearest", "of its branches" },
    { "of_any", "of what they begin on" },
} };

// Option words, in the order of the enumeration StyleScope.
constexpr std::array<tools::OptionWord, 3> kStyleWords { {
    { "none", "of one branch" },
    { "siblings", "to its siblings" },
    { "deeper", "to siblings and below" },
} };

// Option words, in the order of OutlineTool::Reads.
constexpr std::array<tools::OptionWord, 3> kReadsWords { {
    { "as_at_first", "as at first" },
    { "closely", "closely" },
    { "foot_first", "closely, foot first" },
} };

// Option words, in the order of OutlineTool::SeenFor.
constexpr std::array<tools::OptionWord, 3> kSeenWords { {
    { "seen_fades", "fades" },
    { "seen_stays", "stays" },
    { "with_triangles", "stays, with triangles" },
} };

TreeForm ready_form(OutlineTool const& tool)
{
    if (tool.form == OutlineTool::Form::Usual)
        return {};
    return tree_presets()[static_cast<std::size_t>(tool.form) - 1].form;
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
    // This option is for logs only: BesideGizmo shows a button beside the tool's gizmo, and there
    // is no gizmo.
    visitor.choice({ .words = kReadsWords,
                     .offered = tools::WordOption::Offered::BesideGizmo,
                     .label = "Reads" },
                   tool.reads);
    visitor.choice({ .words = kSeenWords,
                     .offered = tools::WordOption::Offered::InTurn,
                     .label = "What is seen" },
                   tool.seen);
    visit_nodes(visitor, tool.nodes);
    visit_fills(visitor, tool.fills);
}

Result<std::vector<scene::Edit>> form_active(OutlineTool const& tool, scene::Scene const& scene)
{
    auto const* const tree = TRY(active_tree(scene));
    auto form = tree->form;
    if (tool.what == What::Reseed)
        ++form.seed;
    else
        form = form_of(tool, form);
    bool const takes_style = tool.what == What::Reseed && tree->takes_style;
    return std::vector<scene::Edit> { FormTree { scene.drawn->id, form, takes_style } };
}

Result<std::vector<scene::Edit>> draw(tools::Tool const& tool, Stroke const& stroke,
                                      scene::Scene const& scene)
{
    auto const& options = *tool.get<OutlineTool>();
    if (options.what == What::Form || options.what == What::Reseed)
        return form_active(options, scene);
    if (options.what == What::Carry)
        return std::vector<scene::Edit> { TRY(copied_styles(stroke, scene)) };
    if (options.what == What::Leaf)
        if (auto const declared = TRY(declared_leaf(options, stroke, scene)))
            return std::vector<scene::Edit> { *declared };
    if (options.what == What::TurnRound)
        return turned_line(options, stroke, scene);
    return std::vector<scene::Edit> { TRY(drawn_tree(options, stroke, scene)) };
}

} // namespace

TreeForm form_of(OutlineTool const& tool, TreeForm form)
{
    form.levels = static_cast<int>(std::lround(tool.levels));
    form.density = tool.density;
    form.leaves = static_cast<int>(std::lround(tool.leaves));
    form.has_whole_nodes = tool.nodes == NodesOption::Whole;
    if (tool.form != OutlineTool::Form::Usual) {
        auto const ready = ready_form(tool);
        form.patterns = ready.patterns;
        form.leaf_width = ready.leaf_width;
        form.styles = ready.styles;
        form.plane_branches = ready.plane_branches;
        form.base_angle_deg = ready.base_angle_deg;
        form.tip_angle_deg = ready.tip_angle_deg;
        form.rise = ready.rise;
        form.bark = tool.fills == FillsOption::BySpecies ? ready.bark : BarkKind::Furrowed;
    }
    form.leaves_reach_outline = tool.fills >= FillsOption::ToOutline && fills_outline(form);
    // Before BySpecies, only the poplar had angles of its own.
    if (tool.fills != FillsOption::BySpecies) {
        form.rise = 0;
        if (tool.form != OutlineTool::Form::Poplar)
            form.base_angle_deg = 0, form.tip_angle_deg = 0;
    }
    form.bases_by_angle = tool.fills == FillsOption::BySpecies && form.base_angle_deg > 0;
    if (tool.fills == FillsOption::AsAtFirst)
        form.plane_branches = 0, form.base_angle_deg = 0, form.tip_angle_deg = 0;
    else if (form.plane_branches == 0)
        form.plane_branches = kUsualPlaneBranches;
    return form;
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
      "crown in the picture behind is its outline; read closely, a trunk that ends just below a "
      "crown is its trunk, and a touch on a bump declares that a leaf; foot first, a line from "
      "tip to foot is turned round, and a touch turns a trunk or branch round; in a ready form, or "
      "with so "
      "many levels of branches, so many times as many as usual that nobody draws, so many leaves "
      "on a twig; with whole nodes, so that the branches of a whorl or a pair stand together, and "
      "filled by "
      "spacing where an outline has few bumps; a "
      "new tree at each line, or at once these numbers, or other chance, for the tree that is "
      "there",
    .group = "Sketch",
    .method = "From an outline",
    .icon = "5954 371624416184866737",
    .key = 'O',
    .surface = tools::Surface::Paper,
    .makes = &OutlinedTree::kKind,
    .options = tools::options_type<OutlineTool, visit>(),
    .edits_for = draw,
    .describe = describe_tree,
    .previewer = outline_previewer,
    .other_end = { &EraseOutlineTool::kKind },
};

} // namespace tractus::silhouette
