#include "engine/methods/self_organising/life.h"

#include "engine/methods/self_organising/wood.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus::self_organising {

SagLaws sag_laws(Habit const& habit)
{
    // Mass of a leaf per area: 150 g per square metre.
    constexpr double kPerSquareMillimetre_kg = 1.5e-7;
    // Share of its bounding rectangle that a leaf fills.
    double const share = habit.leaf_is_needle != 0 ? 1 : 0.65;
    double const leaf_kg = share * habit.leaf_mm * habit.leaf_width_mm * kPerSquareMillimetre_kg;
    return { .weight = habit.weight,
             .leaf_kg = habit.leaves_at_node * leaf_kg,
             .leaf_years = static_cast<int>(habit.leaf_years) };
}

Result<StepCount> grow_year(GrowingTree& tree, Surroundings& surroundings, Habit const& habit)
{
    auto laws = growth_laws_in_year(habit, tree.step + 1);
    double const ground = tree.places[0].position.z();
    double highest = ground;
    for (auto const& place : tree.places)
        highest = std::max(highest, place.position.z());
    laws.ground = ground + habit.clear_share * (highest - ground);
    auto const count = TRY(grow_step(tree, surroundings, laws));
    tree.is_brushed = false;
    sag(tree, diameters(tree, laws), sag_laws(habit));
    return count;
}

Result<GrowingTree> grow_without_brush(Habit const& habit, int years, std::uint64_t seed)
{
    TRY(check_habit(habit));
    if (years < 1 || years > kMaxYears)
        return fail(
            Fault::User,
            fmt::format("a tree grows for 1 to {} years, and {} are asked for", kMaxYears, years));
    auto tree = plant_seed(Vec3::Zero());
    Surroundings surroundings { .seed = seed };
    for (int year = 1; year <= years; ++year)
        TRY(grow_year(tree, surroundings, habit));
    return tree;
}

} // namespace tractus::self_organising
