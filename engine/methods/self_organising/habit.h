#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/laws.h"

#include <span>
#include <string>

namespace tractus::self_organising {

// How a species grows: the numbers of a habit file (app/habits). Lengths in millimetres at the
// plant's natural size, angles in degrees. Numbers that end in _old hold from `old_years` on;
// before, they change evenly from those of a seedling.
struct Habit {
    std::string name = "tree"; // For people, as "oak".
    std::string latin {};      // "Quercus robur".
    std::string leaves {}; // One of our grown leaves (app/leaves), or empty: the plain shape below.

    // Shoots of one year.
    double internode_mm = 100;
    double most_internodes = 4, most_internodes_old = 4; // Of one shoot.
    // Of shoots of all axes but the trunk, and of those that these bear.
    double branch_internodes = 4, twig_internodes = 4;
    double longest = 1.5; // Longest internode, in internodes.
    double vigour = 2, vigour_old = 2;
    double apical_control = 0.5, apical_control_old = 0.48;
    double old_years = 40;
    double terminal_loss = 0; // Share of lateral shoots whose terminal bud dies.
    double bud_life = 4;      // Years that a lateral bud waits.

    // Branching; "lateral" numbers hold for all axes but the trunk.
    double angle_deg = 50, lateral_angle_deg = 45;
    double divergence_deg = 137.5, lateral_divergence_deg = 137.5;
    double lateral_start_deg = 0; // 90 with a divergence of 180: laterals stand in a flat spray.
    double divergence_spread_deg = 12, angle_spread_deg = 8; // Chance: standard deviations.
    double laterals_at_node = 1;
    double whorl = 0; // Laterals at the end of each year's shoot of the trunk; 0: as at any node.
    // Upward tropism of the trunk, its branches, their branches, and all twigs above; negative:
    // down.
    double tropism_trunk = 0.1, tropism_branches = 0.1, tropism_twigs = 0.1, tropism_last = 0.1;
    double space_weight = 0.35; // Pull towards light, or towards the brush's free space.

    // Light.
    double cell_mm = 200; // Side of the cells in which shade is kept.
    double shade = 0.08, shade_fall = 2, shade_depth = 4; // As in Laws.
    double sight_cells = 3, sight_angle_deg = 90;         // Perception, in cells.
    double shed_below = 0.2, shed_below_old = 0.2;
    double clear_share = 0; // Share of the tree's height below which buds receive no light.

    // Wood.
    double pipe_exponent = 2.3;
    double twig_mm = 3; // Diameter of the last twigs.
    double weight
        = 1; // How much branches sag, as a multiple of what green wood of that width does.
    double flare = 0.5; // By how much of its width the trunk is wider at the ground.

    // Leaves on the shoots of the last years.
    double leaf_years = 1;
    double leaves_at_node = 1;
    double leaf_mm = 80, leaf_width_mm = 45, petiole_mm = 10;
    double leaf_angle_deg = 60; // Between leaf and shoot.
    double leaf_is_needle = 0;  // 1: a needle; 0: a blade.
    double leaf_is_evergreen = 0;
    double leaf_red = 0.25, leaf_green = 0.42, leaf_blue = 0.13; // sRGB, 0 to 1.
    double bark_red = 0.34, bark_green = 0.28, bark_blue = 0.22;

    bool operator==(Habit const&) const = default;
};

// One number of a habit: what it is called in habit files and in sessions, where it never changes.
struct HabitNumber {
    char const* key;
    double Habit::*value;
    double least;
    double most;
    bool is_whole = false;
};
std::span<HabitNumber const> habit_numbers();

// Fails, as the user's fault, for a number out of its range: which, and the range.
Result<void> check_habit(Habit const& habit);

// The laws of a year in the life of a tree, from 1: lengths in millimetres, Light.
Laws laws_in_year(Habit const& habit, int year);

// The same where buds compete for the markers of a brush: Space, with internodes of that length.
Laws laws_of_brush(Habit const& habit, int year, double internode_mm);

} // namespace tractus::self_organising
