#include "app/methods/sketch_lsystem/sketch_tool.h"

#include "app/methods/sketch_lsystem/rule_gizmo.h"
#include "app/methods/sketch_lsystem/shorten_sketch_tool.h"
#include "app/methods/sketch_lsystem/sketch_options.h"
#include "app/methods/sketch_lsystem/sketch_previewer.h"
#include "engine/methods/sketch_lsystem/change_edits.h"
#include "engine/scene/paper.h"
#include "engine/stroke/foot_first.h"

#include <algorithm>
#include <utility>

namespace tractus::sketch {

namespace {

bool is_on_branch(SketchTool const& tool)
{
    return tool.place == SketchTool::Place::Branch || tool.place == SketchTool::Place::InPlace;
}

Result<sketch::GrownPart> grown_last(scene::Scene const& scene)
{
    auto const grown = sketch::newest_grown(*scene.drawn);
    if (!grown)
        return fail(Fault::User,
                    "the plant that takes what is drawn has not grown along a stroke: choose one "
                    "that has, or draw one");
    return *grown;
}

// The model of the tool's preset, with the random seed of the sketch `grown`.
sketch::ModelRule model_for(SketchTool const& tool, sketch::GrowAlongStroke const& grown)
{
    auto model = model_of(tool);
    model.seed = grown.model.seed;
    return model;
}

Result<std::vector<scene::Edit>> change(SketchTool const& tool, scene::Scene const& scene)
{
    auto const grown = TRY(grown_last(scene));
    if (tool.card == SketchTool::Card::Plant)
        return fail(Fault::User, "the plant grows by its own rule already: choose another one");
    if (auto model = model_for(tool, *grown.sketch); model.is_set())
        return std::vector<scene::Edit> { sketch::ChangeSketch {
            scene.drawn->id, grown.part, grown.sketch->rule, tool.leaves, std::move(model) } };
    auto const& before = grown.sketch->rule;
    auto rule = with_options(before, tool);
    // Numbers that the user has not set keep their values in the sketch. The thickness is always
    // set. Recordings rely on both.
    SketchTool const plain;
    rule.first_width_mm = rule_of(tool).first_width_mm;
    if (tool.width_ratio == plain.width_ratio)
        rule.width_ratio = before.width_ratio;
    if (tool.lateral_width == plain.lateral_width)
        rule.lateral_width = before.lateral_width;
    if (tool.shortest_mm == plain.shortest_mm && tool.card == plain.card)
        rule.shortest_mm = before.shortest_mm;
    return std::vector<scene::Edit> { sketch::ChangeSketch { scene.drawn->id, grown.part, rule,
                                                             tool.leaves } };
}

Result<std::vector<scene::Edit>> draw_again(SketchTool const& tool, Stroke const& stroke,
                                            scene::Scene const& scene)
{
    auto const grown = TRY(grown_last(scene));
    auto again = TRY(regrown_along(tool, stroke, scene));
    return std::vector<scene::Edit> { sketch::RedrawSketch { scene.drawn->id, grown.part,
                                                             again.surface, std::move(again.stroke),
                                                             again.is_drawn_reversed } };
}

// Reverses the stroke of the active plant's newest sketch. Doing so twice restores the plant.
Result<std::vector<scene::Edit>> turn_round(scene::Scene const& scene)
{
    auto const grown = TRY(grown_last(scene));
    return std::vector<scene::Edit> { sketch::RedrawSketch {
        scene.drawn->id, grown.part, grown.sketch->surface, turned_round(grown.sketch->stroke),
        !grown.sketch->is_drawn_reversed } };
}

// Message for the user if the stroke was reversed, and how to reverse it again; otherwise empty.
std::string say_turned(tools::Tool const& tool, scene::Scene const& after)
{
    auto const grown = sketch::newest_grown(*after.drawn);
    auto const place = tool.get<SketchTool>()->place;
    if (place == SketchTool::Place::TurnRound)
        return "The stroke is turned round";
    if (place == SketchTool::Place::Change || !grown || !grown->sketch->is_drawn_reversed)
        return {};
    return "The stroke ran from the tip to the foot and is turned round: \"Turn round\" turns it "
           "back";
}

// Applies changed options to all plants and parts that were grown by the old rule or model.
std::vector<scene::Edit> follow(tools::Tool const& before, tools::Tool const& after,
                                scene::Scene const& scene)
{
    auto const& old = *before.get<SketchTool>();
    auto const& options = *after.get<SketchTool>();
    std::vector<scene::Edit> edits;
    if (options.drawn == SketchTool::Drawn::Stays || options.card == SketchTool::Card::Plant)
        return edits;
    for (auto const& plant : scene.state.plants)
        for (auto const& [part, grown] : sketch::all_grown(*plant))
            if (matches_sketch(old, *grown) && !matches_sketch(options, *grown))
                edits.push_back(sketch::ChangeSketch { plant->id, part,
                                                       with_options(grown->rule, options),
                                                       grown->leaves, model_for(options, *grown) });
    return edits;
}

std::optional<tools::Tool> like_drawn(tools::Tool const& tool, scene::Scene const& scene)
{
    auto const grown = sketch::newest_grown(*scene.drawn);
    if (!grown)
        return std::nullopt;
    auto options = with_options_of_sketch(*tool.get<SketchTool>(), *grown->sketch);
    options.leaves = grown->sketch->leaves;
    return tools::Tool(options);
}

// World positions of the ends of the internodes along the stroke, one for each application of the
// rule.
std::vector<Vec3> applications(tools::Tool const& tool, Stroke const& stroke,
                               scene::Scene const& scene)
{
    auto const& options = *tool.get<SketchTool>();
    if (options.place == SketchTool::Place::Change || options.place == SketchTool::Place::TurnRound)
        return {};
    auto const grown = options.place == SketchTool::Place::Again
        ? regrown_along(options, stroke, scene)
        : grown_along(options, stroke, scene);
    auto nodes_mm = grown ? sketch::drawn_nodes_mm(*grown) : tl::unexpected(grown.error());
    if (!nodes_mm)
        return {}; // For example, the stroke is too short for an internode.
    std::vector<Vec3> ends_mm(nodes_mm->begin() + 1, nodes_mm->end());
    Vec3 const foot_mm = nodes_mm->front();
    for (auto& end_mm : ends_mm) // Moves a plant that was drawn on paper to the ground.
        end_mm += sketch::stands_at_mm(*grown) - foot_mm;
    return ends_mm;
}

Result<std::vector<scene::Edit>> grow(tools::Tool const& tool, Stroke const& stroke,
                                      scene::Scene const& scene)
{
    auto const& options = *tool.get<SketchTool>();
    if (options.place == SketchTool::Place::Change)
        return change(options, scene);
    if (options.place == SketchTool::Place::Again)
        return draw_again(options, stroke, scene);
    if (options.place == SketchTool::Place::TurnRound)
        return turn_round(scene);
    auto grown = TRY(grown_along(options, stroke, scene));
    auto const place = TRY(place_of(options, grown, scene));
    if (!place)
        return std::vector<scene::Edit> { std::move(grown) };
    fit_to_branch(grown, *place);
    std::vector<scene::Edit> edits { std::move(grown) };
    for (auto& edit : tools::graft_edits(scene, *place, 0))
        edits.push_back(std::move(edit));
    return edits;
}

} // namespace

// Takes the rule or model by which the active plant has grown along a stroke; if it has not, takes
// the model that was loaded for it.
static Result<void> take_from_plant(sketch::GrowAlongStroke& edit, scene::Scene const& scene)
{
    if (auto const grown = sketch::newest_grown(*scene.drawn)) {
        edit.rule = grown->sketch->rule;
        edit.model = grown->sketch->model;
        return {};
    }
    auto const* const loaded = scene::loaded_model(scene.drawn->source);
    if (!loaded)
        return fail(Fault::User,
                    "the plant that takes what is drawn is neither from a rule nor from a model "
                    "that could grow along the stroke: choose one that is, or a rule");
    edit.model = { .source = loaded->source, .includes = loaded->includes };
    return {};
}

// Reverses a stroke that was drawn from the plant's tip down to its foot. On paper this is clear,
// as plants stand on the desk. In space, a stroke that goes down may also be a hanging plant. So it
// is reversed only if it ends as low as the bases of the other plants, or if there are no other
// plants.
static void stand_at_foot(sketch::GrowAlongStroke& edit, SketchTool const& tool,
                          scene::Scene const& scene)
{
    if (tool.stands == SketchTool::Stands::AsDrawn || is_on_branch(tool))
        return;
    std::optional<double> ground_mm;
    if (edit.surface == StrokeSurface::Space)
        for (auto const& plant : scene.state.plants)
            ground_mm
                = std::min(ground_mm.value_or(plant->stands_at_mm.z()), plant->stands_at_mm.z());
    edit.is_drawn_reversed
        = is_drawn_to_foot(plant_tips(edit.stroke.tips.vector(), edit.surface), ground_mm);
    if (edit.is_drawn_reversed)
        edit.stroke = turned_round(edit.stroke);
}

Result<sketch::GrowAlongStroke> grown_along(SketchTool const& tool, Stroke const& stroke,
                                            scene::Scene const& scene)
{
    sketch::GrowAlongStroke edit;
    edit.rule = rule_of(tool);
    edit.model = model_of(tool);
    if (tool.card == SketchTool::Card::Plant)
        TRY(take_from_plant(edit, scene));
    edit.model.seed = 1 + scene.plants.size(); // A different seed for each plant of a drawing.
    edit.stroke = stroke;
    // A stroke that begins on a branch is in space, even if the surface hardly moves meanwhile.
    edit.surface = is_on_branch(tool) && tool.surface == StrokeSurface::Decided
        ? StrokeSurface::Space
        : resolve_surface(stroke.tips, tool.surface);
    edit.leaves = tool.leaves;
    if (!scene.plants.empty())
        edit.scale = scene.placement.scale;
    stand_at_foot(edit, tool, scene);
    return edit;
}

Result<sketch::GrowAlongStroke> regrown_along(SketchTool const& tool, Stroke const& stroke,
                                              scene::Scene const& scene)
{
    auto again = *TRY(grown_last(scene)).sketch;
    again.stroke = stroke;
    again.surface = resolve_surface(stroke.tips, tool.surface);
    again.is_drawn_reversed = false;
    if (TRY(grown_last(scene)).part == 0)
        stand_at_foot(again, tool, scene);
    return again;
}

void fit_to_branch(sketch::GrowAlongStroke& grown, tools::BranchPlace const& place)
{
    // Thickness of the plant's stem as a share of the branch's diameter.
    constexpr double kThinner = 0.85;
    // Minimum thickness of the stem, as a share of the first internode's length.
    constexpr double kThinnest = 0.02;
    auto& rule = grown.rule;
    rule.first_width_mm
        = std::clamp(kThinner * place.diameter_mm, kThinnest * rule.first_length_mm,
                     std::max(rule.first_width_mm, kThinnest * rule.first_length_mm));
}

Result<std::optional<tools::BranchPlace>>
place_of(SketchTool const& tool, sketch::GrowAlongStroke const& grown, scene::Scene const& scene)
{
    if (!is_on_branch(tool) || grown.stroke.tips.empty())
        return std::nullopt;
    Vec3 const down_mm = grown.stroke.tips.front().position_mm;
    auto const grafting = tool.place == SketchTool::Place::InPlace ? tools::Grafting::InPlace
                                                                   : tools::Grafting::Beside;
    if (grown.surface == StrokeSurface::Paper)
        return TRY(tools::branch_at(scene,
                                    scene::paper_of(scene.state).world_of_sheet(down_mm.head<2>()),
                                    Vec3::UnitY(), grafting));
    return TRY(tools::branch_at(scene, down_mm, Vec3::UnitZ(), grafting));
}

static bool may_draw_on_paper(tools::Tool const& tool)
{
    auto const& sketch = *tool.get<SketchTool>();
    return sketch.surface == StrokeSurface::Paper
        || (sketch.surface == StrokeSurface::Decided && !is_on_branch(sketch));
}

constexpr tools::ToolKind SketchTool::kKind {
    .word = "sketch",
    .label = "Rule",
    .title = "A rule grows along the stroke",
    .done = "A plant has grown along the stroke",
    .help
    = "adds a plant: a rule grows along the stroke, a ready one or with so many laterals at "
      "an angle in "
      "degrees, a first internode of so many mm, the next ones and laterals by ratios; laterals "
      "fork or go on by a ready rule of their own, or by the rule itself; with leaves or bare; as "
      "drawn in space, on "
      "paper that stands upright, or whichever the "
      "surface's way shows; alone, on the branch where the stroke begins, or in its place; "
      "or another stroke, or at once these numbers, or the stroke turned round, for what has grown "
      "along a stroke last; laterals that give way stay so many mm away from other parts of the "
      "axis; a plant stands where its stroke begins, or at the stroke's foot; "
      "in the rule's place one of our models, whose trunk or stem the stroke becomes, or what "
      "the plant is that takes what is drawn",
    .group = "Sketch",
    .method = "Along a stroke",
    .icon = "5950 5674 5422 5362",
    .key = 'K',
    .min_extent_mm = 8,
    .may_draw_on_paper = may_draw_on_paper,
    .options = tools::options_type<SketchTool, visit_sketch_options>(),
    .gizmo = &kRuleGizmo,
    .edits_for = grow,
    .follow = follow,
    .like_drawn = like_drawn,
    .describe = say_turned,
    .previewer = sketch_previewer,
    .steps = applications,
    .other_end = { &ShortenSketchTool::kKind },
};

} // namespace tractus::sketch
