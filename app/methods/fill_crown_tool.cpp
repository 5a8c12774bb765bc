#include "app/methods/fill_crown_tool.h"

#include "app/tools/erase_tool.h"
#include "engine/methods/self_organising/grown_tree.h"
#include "engine/methods/silhouettes/crown_volume.h"
#include "engine/methods/silhouettes/tree_edits.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <string>
#include <utility>

namespace tractus::methods {

namespace {

// Maximum number of years; growth ends earlier when the space is used up.
constexpr int kFillYears = 40;

// Option words, in the order of FillCrownTool::When.
constexpr std::array<tools::OptionWord, 2> kWhenWords { {
    { "touch", "At a touch" },
    { "now_fill", "Fill the crown", nullptr, true },
} };

void visit(tools::OptionVisitor& visitor, FillCrownTool& tool)
{
    visitor.choice({ .words = kWhenWords }, tool.when);
    self_organising::visit_species(visitor, tool.species);
    self_organising::visit_edition(visitor, tool.edition);
}

// Returns a growth period in which the tree grows inside the balls. The period's stroke has a tip
// for each ball, whose pressure encodes the ball's radius.
self_organising::LifePeriod part_of(std::vector<silhouette::CrownBall> const& balls,
                                    scene::BuiltPlant const& plant)
{
    auto const& placement = plant.placement;
    double const widest = balls.front().radius_mm;
    double const narrowest = balls.back().radius_mm;
    std::vector<TipSample> tips;
    for (auto const& [centre_mm, radius_mm] : balls)
        tips.push_back(
            { .position_mm = placement.world_of_plant(centre_mm),
              .pressure = widest > narrowest ? (radius_mm - narrowest) / (widest - narrowest) : 1,
              .touching = true });
    return { .stroke = { std::move(tips) },
             .is_volume = true,
             .min_radius_mm = narrowest * placement.scale,
             .most_radius_mm = widest * placement.scale };
}

Result<std::vector<scene::Edit>> fill_edits(tools::Tool const& tool, Stroke const&,
                                            scene::Scene const& scene)
{
    auto const& options = *tool.get<FillCrownTool>();
    auto const habit = self_organising::habit_of(options.species, options.edition);
    return std::vector { TRY(fill_crown(scene, habit, kFillYears, 1 + scene.plants.size())) };
}

std::string describe_filled(tools::Tool const&, scene::Scene const& after)
{
    return fmt::format("The crown is filled: {} branches, {} leaves", after.base->axes.size(),
                       after.base->organs.size());
}

} // namespace

Result<scene::Edit> fill_crown(scene::Scene const& scene, self_organising::Habit const& habit,
                               int years, std::uint64_t seed)
{
    auto const* const tree = silhouette::outlined_tree(*scene.drawn);
    if (!tree)
        return fail(Fault::User,
                    "the plant was not drawn by its outline: choose a tree that was, "
                    "so that its crown can be filled");
    auto const balls = silhouette::fill_with_balls(TRY(silhouette::crown_volume(*tree)));
    if (balls.empty())
        return fail(Fault::User, "the crown encloses no space: draw a wider outline");
    auto part = part_of(balls, scene);
    part.years = years;
    return scene::Edit(
        self_organising::GrowFrom { .plant = scene.drawn->id,
                                    .habit = habit,
                                    .seed = seed,
                                    .next = std::move(part),
                                    .kept_axes = TRY(silhouette::drawn_axes(*tree)) });
}

constexpr tools::ToolKind FillCrownTool::kKind {
    .word = "fill_crown",
    .label = "Fill crown",
    .title = "A tree grows to fill an outlined crown",
    .done = "The crown is filled",
    .help = "lets a tree of a species fill the crown of the active tree, which was drawn by its "
            "outline: trunk and drawn branches remain, and buds on them compete for the space "
            "inside; at a touch, or at once",
    .group = "Sketch",
    .method = "Growth brush",
    .options = tools::options_type<FillCrownTool, visit>(),
    .edits_for = fill_edits,
    .describe = describe_filled,
    .other_end = { &tools::EraseTool::kKind },
};

} // namespace tractus::methods
