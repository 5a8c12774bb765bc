#include "app/methods/self_organising/growth_brush_tool.h"

#include "app/methods/self_organising/habit_text.h"
#include "app/methods/self_organising/prune_tool.h"
#include "engine/base/check.h"
#include "engine/methods/self_organising/life.h"
#include "engine/stroke/foot_first.h"
#include "engine/stroke/upright_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace tractus::self_organising {

namespace {

using What = GrowthBrushTool::What;

// Words for the habits, in the order of the enumeration Species.
constexpr std::array<tools::OptionWord, 16> kHabitWords { {
    { "oak", "Oak" },
    { "beech", "Beech" },
    { "lime", "Lime" },
    { "maple", "Maple" },
    { "ash", "Ash" },
    { "cherry", "Cherry" },
    { "birch", "Birch" },
    { "alder", "Alder" },
    { "plane", "Plane" },
    { "poplar", "Poplar" },
    { "willow", "Willow" },
    { "apple", "Apple" },
    { "pine", "Pine" },
    { "spruce", "Spruce" },
    { "fir", "Fir" },
    { "larch", "Larch" },
} };

// Option words, in the order of the enumeration Edition. Logs without one are of the first edition.
constexpr std::array<tools::OptionWord, 3> kEditionWords { {
    { "pipe", "By the pipe model" },
    { "rings", "With annual rings" },
    { "full", "Full crowns" },
} };

// Option words, in the order of the enumeration What.
constexpr std::array<tools::OptionWord, 11> kWhatWords { {
    { "go_on", "Go on" },
    { "new", "New tree" },
    { "year", "A year by itself", nullptr, true },
    { "ten_years", "Ten years", nullptr, true },
    { "habit", "To this tree", nullptr, true },
    { "reseed", "Another one", nullptr, true },
    { "from", "From any plant" },
    { "from_year", "A year from it", nullptr, true },
    { "all_year", "A year for all", nullptr, true },
    { "all_ten_years", "Ten for all", nullptr, true },
    { "turned", "Turn round", nullptr, true },
} };

void visit(tools::OptionVisitor& visitor, GrowthBrushTool& tool)
{
    visit_species(visitor, tool.species);
    visitor.number({ "years_per_s", "", 0.5, 20, 0.5, "Years a second" }, tool.years_per_s);
    visitor.number({ "least_radius", "mm", 1, 100, 1, "Light" }, tool.min_radius_mm);
    visitor.number({ "radius", "mm", 2, 200, 2, "Pressed" }, tool.most_radius_mm);
    visitor.choice({ kWhatWords }, tool.what);
    visit_edition(visitor, tool.edition);
    tools::visit_base(visitor, tool.base);
}

Result<GrownTree const*> active_tree(scene::Scene const& scene)
{
    auto const* const tree = grown_tree_of(scene.drawn->source);
    if (!tree)
        return fail(
            Fault::User,
            "the plant that takes what is drawn has not grown by itself or under the brush: "
            "choose one that has, or draw one");
    return tree;
}

// True if a stroke begins so close to the active plant's nodes that it continues that plant.
bool begins_on_plant(Stroke const& stroke, double radius_mm, scene::Scene const& scene)
{
    // Maximum distance from a node, as a multiple of the brush's radius.
    constexpr double kNear = 1.5;
    Vec3 const at_mm = scene.placement.plant_of_world(stroke.tips.front().position_mm);
    double const near_mm = kNear * radius_mm / scene.placement.scale;
    auto const& nodes = scene.base->node_position_mm;
    return std::any_of(nodes.begin(), nodes.end(), [&](Vec3 const& node_mm) {
        return (node_mm - at_mm).squaredNorm() <= near_mm * near_mm;
    });
}

Result<std::vector<scene::Edit>> grow_without_brush(GrowthBrushTool const& tool,
                                                    scene::Scene const& scene)
{
    LifePeriod const part { .years = tool.what == What::Year ? 1 : 10 };
    if (scene.plants.empty())
        return std::vector<scene::Edit> { PlantTree { .habit = habit_of(tool.species, tool.edition),
                                                      .first = part } };
    TRY(active_tree(scene));
    return std::vector<scene::Edit> { GrowOn { scene.drawn->id, part } };
}

Result<std::vector<scene::Edit>> change_habit(GrowthBrushTool const& tool,
                                              scene::Scene const& scene)
{
    auto const* const tree = TRY(active_tree(scene));
    bool const is_other_chance = tool.what == What::Reseed;
    return std::vector<scene::Edit> { ChangeHabit {
        scene.drawn->id, is_other_chance ? tree->habit : habit_of(tool.species, tool.edition),
        tree->seed + (is_other_chance ? 1 : 0) } };
}

Result<std::vector<scene::Edit>> edits_for(tools::Tool const& tool, Stroke const& stroke,
                                           scene::Scene const& scene)
{
    auto const& options = *tool.get<GrowthBrushTool>();
    if (options.what == What::Year || options.what == What::TenYears)
        return grow_without_brush(options, scene);
    if (options.what == What::AllYear || options.what == What::AllTenYears)
        return std::vector<scene::Edit> { GrowStand { .years
                                                      = options.what == What::AllYear ? 1 : 10 } };
    if (options.what == What::TurnRound) {
        TRY(active_tree(scene));
        return std::vector<scene::Edit> { TurnBrushStroke { scene.drawn->id } };
    }
    auto const habit = habit_of(options.species, options.edition);
    if (options.what == What::FromYear)
        return std::vector { TRY(grow_from_active(scene, habit, { .years = 1 })) };
    if (options.what == What::Habit || options.what == What::Reseed)
        return change_habit(options, scene);
    auto life = TRY(life_of_brush_stroke(options, stroke, scene));
    if (options.what == What::From)
        return std::vector { TRY(grow_from_active(scene, habit, std::move(life.part))) };
    if (life.plant != 0)
        return std::vector<scene::Edit> { GrowOn { life.plant, std::move(life.part) } };
    return std::vector<scene::Edit> { PlantTree {
        .habit = habit,
        .seed = 1 + scene.plants.size(), // A different seed for each tree of a drawing.
        .first = std::move(life.part) } };
}

// True if a brush stroke that begins a tree was drawn from the tree's top to its foot: it ends as
// low as the other plants stand, or there are none.
bool is_drawn_from_top(Stroke const& stroke, scene::Scene const& scene)
{
    std::optional<double> ground_mm;
    for (auto const& plant : scene.state.plants)
        ground_mm = std::min(ground_mm.value_or(plant->stands_at_mm.z()), plant->stands_at_mm.z());
    return is_drawn_to_foot(plant_tips(stroke.tips.vector(), StrokeSurface::Space), ground_mm);
}

std::string describe_grown(tools::Tool const& tool, scene::Scene const& after)
{
    auto const* const tree = grown_tree_of(after.drawn->source);
    if (!tree)
        return {};
    if (tool.get<GrowthBrushTool>() && tool.get<GrowthBrushTool>()->what == What::TurnRound)
        return "The brush's stroke is turned round";
    if (tree->life.size() == 1 && tree->life.front().is_drawn_reversed)
        return "The stroke ran from the tree's top to its foot and is turned round: \"Turn round\" "
               "turns it back";
    int years = 0;
    for (auto const& part : tree->life)
        years += years_of(part);
    return fmt::format("The {} has grown {} years: {} branches, {} leaves", tree->habit.name, years,
                       after.base->axes.size(), after.base->organs.size());
}

} // namespace

void visit_species(tools::OptionVisitor& visitor, GrowthBrushTool::Species& species)
{
    visitor.choice(
        { .words = kHabitWords, .offered = tools::WordOption::Offered::Cards, .label = "Habit" },
        species);
}

void visit_edition(tools::OptionVisitor& visitor, GrowthBrushTool::Edition& girth)
{
    visitor.choice({ kEditionWords, tools::WordOption::Offered::Never }, girth);
}

bool is_unmodified(scene::PlantState const& plant)
{
    return plant.strokes.empty() && plant.indicators.empty() && plant.grafts.empty()
        && plant.hidden_branches.empty();
}

Result<scene::Edit> grow_from_active(scene::Scene const& scene, Habit const& habit, LifePeriod part)
{
    if (scene.plants.empty())
        return fail(Fault::User,
                    "there is no plant from which a tree could grow: draw or open one first");
    auto const& drawn = *scene.drawn;
    auto const* const tree = grown_tree_of(drawn.source);
    if (tree && is_unmodified(drawn))
        return scene::Edit(GrowOn { drawn.id, std::move(part) });
    return scene::Edit(GrowFrom { .plant = drawn.id,
                                  .habit = tree ? tree->habit : habit,
                                  .seed = tree ? tree->seed : 1 + scene.plants.size(),
                                  .next = std::move(part) });
}

Habit habit_of(GrowthBrushTool::Species species, GrowthBrushTool::Edition edition)
{
    std::string_view const name = kHabitWords[static_cast<std::size_t>(species)].word;
    char const* text = nullptr;
    for (auto const& known : habit_texts())
        if (known.name == name && (!known.is_earlier || edition != GrowthBrushTool::Edition::Full))
            text = known.text;
    CHECK(text);
    auto habit = parse_habit(text, std::string(name));
    CHECK(habit.has_value());
    if (edition == GrowthBrushTool::Edition::Pipe)
        habit->ring_mm = 0;
    return *std::move(habit);
}

Result<BrushStrokeLife> life_of_brush_stroke(GrowthBrushTool const& tool, Stroke const& stroke,
                                             scene::Scene const& scene)
{
    auto const tips = TRY(stroke.tips.in_memory());
    if (tips.empty())
        return fail(Fault::User, "the stroke is empty: draw where the tree shall grow");
    double const seconds = to_seconds(tips.back().time - tips.front().time);
    BrushStrokeLife life { .part = { .years = static_cast<int>(std::clamp(
                                         std::floor(seconds * tool.years_per_s), 1.0, 100.0)),
                                     .stroke = stroke,
                                     .min_radius_mm = tool.min_radius_mm,
                                     .most_radius_mm = tool.most_radius_mm,
                                     .waits_outside = true,
                                     .seconds_per_year = 1 / tool.years_per_s } };
    bool const is_tree = !scene.plants.empty() && grown_tree_of(scene.drawn->source);
    if (tool.what == What::GoOn && is_tree && begins_on_plant(stroke, tool.most_radius_mm, scene))
        life.plant = scene.drawn->id;
    bool const begins_tree = life.plant == 0 && tool.what != What::From;
    if (tool.base == tools::StrokeBase::AtFoot && begins_tree && is_drawn_from_top(stroke, scene)) {
        life.part.stroke = turned_round(stroke);
        life.part.is_drawn_reversed = true;
    }
    return life;
}

constexpr tools::ToolKind GrowthBrushTool::kKind {
    .word = "growth_brush",
    .label = "Growth brush",
    .title = "A tree grows into what the brush sweeps",
    .done = "A tree has grown under the brush",
    .help
    = "a tree of a species grows into the volume that the pen sweeps as a ball, as wide as it "
      "is pressed, so many years a second: a new one, or the active one where the stroke "
      "begins on it; at once a year or ten by itself, another species in the same volume, or "
      "another tree of this one; or the active plant of any method as it stands and as strokes "
      "have bent it, along a stroke or for a year by itself; or all trees of the drawing beside "
      "each other, in each other's shade; a stroke from a tree's top to its foot is turned round, "
      "or turned back at once",
    .group = "Sketch",
    .method = "Growth brush",
    .icon = "5953 5735 5673 162441618486",
    .options = tools::options_type<GrowthBrushTool, visit>(),
    .edits_for = edits_for,
    .describe = describe_grown,
    .previewer = growth_brush_previewer,
    .other_end = { &PruneTool::kKind },
};

} // namespace tractus::self_organising
