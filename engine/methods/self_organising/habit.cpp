#include "engine/methods/self_organising/habit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>

namespace tractus::self_organising {

namespace {

constexpr std::array kNumbers {
    HabitNumber { "internode_mm", &Habit::internode_mm, 1, 2000 },
    HabitNumber { "most_internodes", &Habit::most_internodes, 1, 20 },
    HabitNumber { "most_internodes_old", &Habit::most_internodes_old, 1, 20 },
    HabitNumber { "branch_internodes", &Habit::branch_internodes, 1, 20 },
    HabitNumber { "twig_internodes", &Habit::twig_internodes, 1, 20 },
    HabitNumber { "longest", &Habit::longest, 1, 10 },
    HabitNumber { "vigour", &Habit::vigour, 0, 20 },
    HabitNumber { "vigour_old", &Habit::vigour_old, 0, 20 },
    HabitNumber { "apical_control", &Habit::apical_control, 0, 1 },
    HabitNumber { "apical_control_old", &Habit::apical_control_old, 0, 1 },
    HabitNumber { "old_years", &Habit::old_years, 1, 1000 },
    HabitNumber { "terminal_loss", &Habit::terminal_loss, 0, 1 },
    HabitNumber { "bud_life", &Habit::bud_life, 0, 1000, true },
    HabitNumber { "angle_deg", &Habit::angle_deg, 0, 180 },
    HabitNumber { "lateral_angle_deg", &Habit::lateral_angle_deg, 0, 180 },
    HabitNumber { "divergence_deg", &Habit::divergence_deg, -360, 360 },
    HabitNumber { "lateral_divergence_deg", &Habit::lateral_divergence_deg, -360, 360 },
    HabitNumber { "lateral_start_deg", &Habit::lateral_start_deg, -360, 360 },
    HabitNumber { "divergence_spread_deg", &Habit::divergence_spread_deg, 0, 180 },
    HabitNumber { "angle_spread_deg", &Habit::angle_spread_deg, 0, 90 },
    HabitNumber { "laterals_at_node", &Habit::laterals_at_node, 0, 8, true },
    HabitNumber { "whorl", &Habit::whorl, 0, 8, true },
    HabitNumber { "tropism_trunk", &Habit::tropism_trunk, -10, 10 },
    HabitNumber { "tropism_branches", &Habit::tropism_branches, -10, 10 },
    HabitNumber { "tropism_twigs", &Habit::tropism_twigs, -10, 10 },
    HabitNumber { "tropism_last", &Habit::tropism_last, -10, 10 },
    HabitNumber { "space_weight", &Habit::space_weight, 0, 10 },
    HabitNumber { "cell_mm", &Habit::cell_mm, 10, 10'000 },
    HabitNumber { "shade", &Habit::shade, 0, 10 },
    HabitNumber { "shade_fall", &Habit::shade_fall, 1, 10 },
    HabitNumber { "shade_depth", &Habit::shade_depth, 0, 12, true },
    HabitNumber { "sight_cells", &Habit::sight_cells, 0, 8 },
    HabitNumber { "sight_angle_deg", &Habit::sight_angle_deg, 0, 360 },
    HabitNumber { "shed_below", &Habit::shed_below, 0, 1 },
    HabitNumber { "shed_below_old", &Habit::shed_below_old, 0, 1 },
    HabitNumber { "clear_share", &Habit::clear_share, 0, 0.9 },
    HabitNumber { "pipe_exponent", &Habit::pipe_exponent, 1.5, 4 },
    HabitNumber { "twig_mm", &Habit::twig_mm, 0.1, 100 },
    HabitNumber { "weight", &Habit::weight, 0, 20 },
    HabitNumber { "flare", &Habit::flare, 0, 3 },
    HabitNumber { .key = "ridges",
                  .value = &Habit::ridges,
                  .least = 0,
                  .most = 12,
                  .is_whole = true,
                  .is_sparse = true },
    HabitNumber {
        .key = "ring_mm", .value = &Habit::ring_mm, .least = 0, .most = 50, .is_sparse = true },
    HabitNumber { .key = "ring_slenderness",
                  .value = &Habit::ring_slenderness,
                  .least = 0,
                  .most = 200,
                  .is_sparse = true },
    HabitNumber { "leaf_years", &Habit::leaf_years, 0, 20, true },
    HabitNumber { "leaves_at_node", &Habit::leaves_at_node, 0, 60, true },
    HabitNumber { "leaf_mm", &Habit::leaf_mm, 1, 2000 },
    HabitNumber { "leaf_width_mm", &Habit::leaf_width_mm, 0.1, 2000 },
    HabitNumber { "petiole_mm", &Habit::petiole_mm, 0, 1000 },
    HabitNumber { "leaf_angle_deg", &Habit::leaf_angle_deg, 0, 180 },
    HabitNumber { "leaf_is_needle", &Habit::leaf_is_needle, 0, 1, true },
    HabitNumber { .key = "shoot_needles",
                  .value = &Habit::shoot_needles,
                  .least = 0,
                  .most = 200,
                  .is_whole = true,
                  .is_sparse = true },
    HabitNumber { "leaf_is_evergreen", &Habit::leaf_is_evergreen, 0, 1, true },
    HabitNumber { "leaf_red", &Habit::leaf_red, 0, 1 },
    HabitNumber { "leaf_green", &Habit::leaf_green, 0, 1 },
    HabitNumber { "leaf_blue", &Habit::leaf_blue, 0, 1 },
    HabitNumber { "bark_red", &Habit::bark_red, 0, 1 },
    HabitNumber { "bark_green", &Habit::bark_green, 0, 1 },
    HabitNumber { "bark_blue", &Habit::bark_blue, 0, 1 },
};

} // namespace

std::span<HabitNumber const> habit_numbers()
{
    return kNumbers;
}

Result<void> check_habit(Habit const& habit)
{
    for (auto const& [key, member, least, most, is_whole, is_sparse] : kNumbers) {
        double const value = habit.*member;
        if (!(value >= least && value <= most))
            return fail(Fault::User,
                        fmt::format("{} is {:g}: give a number from {:g} to {:g}", key, value,
                                    least, most));
        if (is_whole && value != std::floor(value))
            return fail(Fault::User,
                        fmt::format("{} is {:g}: give a whole number from {:g} to {:g}", key, value,
                                    least, most));
    }
    return {};
}

Laws growth_laws_in_year(Habit const& habit, int year)
{
    double const age = std::clamp((year - 1) / habit.old_years, 0.0, 1.0);
    auto const at_age = [&](double young, double old) { return young + age * (old - young); };
    Laws laws;
    laws.environment = Laws::Environment::Light;
    laws.internode = habit.internode_mm;
    laws.cell = habit.cell_mm;
    laws.perception_radius = habit.sight_cells * habit.cell_mm;
    laws.perception_angle_deg = habit.sight_angle_deg;
    laws.shade = habit.shade;
    laws.shade_fall = habit.shade_fall;
    laws.shade_depth = static_cast<int>(habit.shade_depth);
    laws.apical_control = at_age(habit.apical_control, habit.apical_control_old);
    laws.vigour = at_age(habit.vigour, habit.vigour_old);
    laws.space_weight = habit.space_weight;
    laws.tropism_weight.values
        = { habit.tropism_trunk, habit.tropism_branches, habit.tropism_twigs, habit.tropism_last };
    double const of_trunk = at_age(habit.most_internodes, habit.most_internodes_old);
    auto const at_most
        = [&](double most) { return static_cast<int>(std::lround(std::min(most, of_trunk))); };
    auto const twig = at_most(habit.twig_internodes);
    laws.most_internodes.values
        = { at_most(of_trunk), at_most(habit.branch_internodes), twig, twig };
    laws.longest = habit.longest;
    laws.divergence_deg = { habit.divergence_deg, habit.lateral_divergence_deg };
    laws.divergence_start_deg = { 0, habit.lateral_start_deg };
    laws.branching_angle_deg = { habit.angle_deg, habit.lateral_angle_deg };
    laws.divergence_spread_deg = habit.divergence_spread_deg;
    laws.angle_spread_deg = habit.angle_spread_deg;
    laws.laterals_at_node = static_cast<int>(habit.laterals_at_node);
    laws.whorl = static_cast<int>(habit.whorl);
    laws.terminal_loss = habit.terminal_loss;
    laws.bud_life = static_cast<int>(habit.bud_life);
    laws.shed_below = at_age(habit.shed_below, habit.shed_below_old);
    laws.pipe_exponent = habit.pipe_exponent;
    laws.twig_diameter = habit.twig_mm;
    laws.keeps_dead_wood = true;
    return laws;
}

Laws brush_growth_laws(Habit const& habit, int year, double internode_mm)
{
    // Perception radius in internode lengths (Palubicki et al. 2009: 4 to 6).
    constexpr double kPerception = 5;
    // Occupancy radius in internode lengths (Palubicki et al. 2009: 2).
    constexpr double kOccupancy = 2;
    auto laws = growth_laws_in_year(habit, year);
    laws.environment = Laws::Environment::Space;
    laws.internode = internode_mm;
    laws.perception_radius = kPerception * internode_mm;
    laws.occupancy_radius = kOccupancy * internode_mm;
    laws.shed_below = 0; // Branches whose buds find no marker survive and wait for the next stroke.
    laws.bud_life = 0;
    return laws;
}

} // namespace tractus::self_organising
