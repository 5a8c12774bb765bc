#include "app/methods/leaves/leaf_line_tool.h"

#include "app/methods/leaves/erase_leaf_tool.h"
#include "app/methods/leaves/leaf_previewer.h"
#include "engine/methods/leaves/leaf_sketch_edits.h"
#include "engine/scene/paper.h"

#include <array>
#include <cmath>
#include <utility>

namespace tractus::leaf {

namespace {

// Option words, in the order of LeafLineTool::Plant.
constexpr std::array<tools::OptionWord, 2> kPlantWords { {
    { "go_on", "Line" },
    { "new_leaf", "Another leaf" },
} };

// Option words, in the order of LeafLineTool::Leaves.
constexpr std::array<tools::OptionWord, 2> kLeavesWords { {
    { "simple", "Simple leaves" },
    { "compound", "Compound leaves, too" },
} };

void visit(tools::OptionVisitor& visitor, LeafLineTool& tool)
{
    visitor.choice({ kPlantWords }, tool.plant);
    visitor.number({ "bend", "degrees", -180, 180, 5, "Bend" }, tool.bend_deg);
    visitor.number({ "rise", "degrees", -90, 90, 5, "Rise" }, tool.rise_deg);
    visitor.number({ "vein_curve", "degrees", -90, 90, 5, "Veins bend" }, tool.vein_curve_deg);
    visitor.number({ "vein_width", "", 0.2, 5, 0.1, "Veins' width" }, tool.vein_width);
    visitor.number({ "teeth", "", 0, 60, 1, "Teeth" }, tool.teeth);
    visitor.number({ "tooth_depth", "", 0, 0.2, 0.005, "Teeth's depth" }, tool.tooth_depth);
    visitor.number({ "variation", "", 0, 4, 0.25, "Variation" }, tool.variation);
    visitor.choice({ kLeavesWords, tools::WordOption::Offered::Never }, tool.leaves);
}

leaf::LeafForm form_of(LeafLineTool const& tool)
{
    return { .bend_deg = tool.bend_deg,
             .rise_deg = tool.rise_deg,
             .vein_curve_deg = tool.vein_curve_deg,
             .vein_width = tool.vein_width,
             .teeth = static_cast<int>(std::lround(tool.teeth)),
             .tooth_depth = tool.tooth_depth,
             .variation = tool.variation };
}

// Sets `value` to `after` if the user changed this number of the tool, that is, if `before` is
// different.
template<typename T> void follow_number(T& value, T const& before, T const& after)
{
    if (before != after)
        value = after;
}

leaf::LeafForm followed(leaf::LeafForm form, leaf::LeafForm const& before,
                        leaf::LeafForm const& after)
{
    follow_number(form.bend_deg, before.bend_deg, after.bend_deg);
    follow_number(form.rise_deg, before.rise_deg, after.rise_deg);
    follow_number(form.vein_curve_deg, before.vein_curve_deg, after.vein_curve_deg);
    follow_number(form.vein_width, before.vein_width, after.vein_width);
    follow_number(form.teeth, before.teeth, after.teeth);
    follow_number(form.tooth_depth, before.tooth_depth, after.tooth_depth);
    follow_number(form.variation, before.variation, after.variation);
    return form;
}

std::vector<scene::Edit> follow(tools::Tool const& before, tools::Tool const& after,
                                scene::Scene const& scene)
{
    auto const* const sketch = leaf::active_leaf_sketch(scene.state);
    if (!sketch)
        return {};
    auto const form = followed(sketch->form, form_of(*before.get<LeafLineTool>()),
                               form_of(*after.get<LeafLineTool>()));
    if (form == sketch->form)
        return {};
    return { leaf::FormLeaf { scene.state.active, form } };
}

std::optional<tools::Tool> like_drawn(tools::Tool const& tool, scene::Scene const& scene)
{
    auto const* const sketch = leaf::active_leaf_sketch(scene.state);
    if (!sketch)
        return std::nullopt;
    auto options = *tool.get<LeafLineTool>();
    auto const& form = sketch->form;
    options.bend_deg = form.bend_deg;
    options.rise_deg = form.rise_deg;
    options.vein_curve_deg = form.vein_curve_deg;
    options.vein_width = form.vein_width;
    options.teeth = form.teeth;
    options.tooth_depth = form.tooth_depth;
    options.variation = form.variation;
    return tools::Tool(options);
}

// Place of a new leaf on the ground: below the lowest point of its stroke on the paper.
Vec3 stands_at(Stroke const& stroke, scene::DocumentState const& state)
{
    Vec3 lowest_mm = stroke.tips.front().position_mm;
    for (auto const& tip : stroke.tips)
        if (tip.position_mm.y() < lowest_mm.y())
            lowest_mm = tip.position_mm;
    Vec3 at_mm = scene::paper_of(state).world_of_sheet(lowest_mm.head<2>());
    at_mm.z() = 0;
    return at_mm;
}

Result<std::vector<scene::Edit>> add_line(tools::Tool const& tool, Stroke const& stroke,
                                          scene::Scene const& scene)
{
    auto const& options = *tool.get<LeafLineTool>();
    leaf::AddLeafLine edit { .stroke = stroke, .form = form_of(options) };
    edit.may_be_leaflet = options.leaves == LeafLineTool::Leaves::Compound;
    if (options.plant == LeafLineTool::Plant::GoOn && leaf::active_leaf_sketch(scene.state))
        edit.plant = scene.state.active;
    if (!scene.plants.empty())
        edit.scale = scene.placement.scale;
    if (!stroke.tips.empty())
        edit.stands_at_mm = stands_at(stroke, scene.state);
    return std::vector<scene::Edit> { std::move(edit) };
}

std::string describe_leaf(tools::Tool const&, scene::Scene const& after)
{
    auto const* const sketch = leaf::active_leaf_sketch(after.state);
    return sketch ? leaf::describe_result(*sketch) : "";
}

} // namespace

constexpr tools::ToolKind LeafLineTool::kKind {
    .word = "leaf_line",
    .label = "Leaf",
    .title = "Draw a leaf by its outline and veins",
    .done = "The leaf follows the line",
    .help = "adds a line to a leaf on paper that stands upright: its outline, its midrib from the "
            "stalk to the tip, or a vein, or draws one of them again; outlines along a rachis are "
            "the leaflets of a compound "
            "leaf; the leaf bends and rises by "
            "so many degrees more than drawn, has so many teeth on each half, of a depth as a "
            "share of its length, and so much variation where plants wear it",
    .group = "Sketch",
    .method = "A leaf",
    .icon = "5951 57757351 57353351",
    .surface = tools::Surface::Paper,
    .min_extent_mm = 2,
    .options = tools::options_type<LeafLineTool, visit>(),
    .edits_for = add_line,
    .follow = follow,
    .like_drawn = like_drawn,
    .describe = describe_leaf,
    .previewer = leaf_previewer,
    .other_end = { &EraseLeafTool::kKind },
};

} // namespace tractus::leaf
