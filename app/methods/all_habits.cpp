#include "app/methods/all_habits.h"

#include "app/methods/fill_crown_tool.h"
#include "app/methods/self_organising/habit_file.h"
#include "engine/methods/self_organising/grown_tree.h"
#include "engine/scene/edit.h"
#include "engine/variation/growth_preset.h"

#include <cmath>

namespace tractus::methods {

std::vector<std::string> habit_names()
{
    return self_organising::habit_names();
}

Result<scene::Edit> tree_of_habit(std::string const& habit, int years, std::uint64_t seed)
{
    return scene::Edit(
        self_organising::PlantTree { .habit = TRY(self_organising::load_habit(habit)),
                                     .seed = seed,
                                     .first = { .years = years } });
}

Result<std::vector<scene::Edit>> edits_for_stand(StandOfTrees const& stand)
{
    constexpr double kScale = 0.1; // World millimetres per millimetre of a plant.
    auto const habit = TRY(self_organising::load_habit(stand.habit));
    auto const as_drawn = TRY(variation::growth_preset("as drawn"));
    auto const columns = static_cast<int>(std::ceil(std::sqrt(stand.count)));
    auto const rows = (stand.count + columns - 1) / columns;
    double const spacing_mm = 1000 * stand.spacing_m * kScale;
    std::vector<scene::Edit> edits;
    for (int i = 0; i < stand.count; ++i) {
        auto const id = static_cast<scene::ItemId>(i + 1);
        edits.emplace_back(
            self_organising::PlantTree { .habit = habit,
                                         .seed = stand.seed + static_cast<std::uint64_t>(i),
                                         .scale = kScale,
                                         .first = { .years = 1 },
                                         .id = id });
        edits.emplace_back(scene::SetGrowth { as_drawn, stand.seed });
        Vec2 const middle(0.5 * (columns - 1), 0.5 * (rows - 1));
        Vec2 const at = spacing_mm * (Vec2(i % columns, i / columns) - middle);
        edits.emplace_back(scene::MovePlant { id, Vec3(at.x(), at.y(), 0) });
    }
    if (stand.years > 1)
        edits.emplace_back(self_organising::GrowStand { stand.years - 1 });
    return edits;
}

Result<scene::Edit> growth_from(scene::Scene const& scene, GrowthFrom const& growth)
{
    auto const habit = TRY(self_organising::load_habit(growth.habit));
    if (growth.fills)
        return fill_crown(scene, habit, growth.years, growth.seed);
    return scene::Edit(self_organising::GrowFrom { .plant = scene.drawn->id,
                                                   .habit = habit,
                                                   .seed = growth.seed,
                                                   .next = { .years = growth.years } });
}

Result<std::optional<self_organising::TreeFilm>> years_of_tree(scene::Scene const& scene,
                                                               scene::LoadOptions const& options)
{
    auto const* const tree = self_organising::grown_tree_of(scene.drawn->source);
    if (scene.plants.size() != 1 || !tree || !self_organising::is_unmodified(*scene.drawn))
        return std::nullopt;
    return TRY(self_organising::TreeFilm::make(*tree, options));
}

} // namespace tractus::methods
