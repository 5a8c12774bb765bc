#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/laws.h"

#include <span>
#include <string>

namespace tractus::self_organising {

// The growth habit of a species: the numbers of a habit file (app/habits). Lengths are in
// millimetres at natural size, angles in degrees. Some values have a second field, ending in _old:
// the first field is the value of a seedling, the second that of a tree of `old_years` years or
// more, with linear interpolation between them.
struct Habit {
    std::string name = "tree"; // Common name, such as "oak".
    std::string latin {};      // Botanical name, such as "Quercus robur".
    // Name of a shipped grown leaf (app/leaves); empty: the plain leaf described below.
    std::string leaves {};

    // The fields from here on describe annual shoots.
    double internode_mm = 100;
    // Maximum number of internodes of an annual shoot of the trunk.
    double most_internodes = 4, most_internodes_old = 4;
    // Maximum number of internodes of an annual shoot on axes of order 1, and on axes of order 2
    // and above; never more than the trunk's.
    double branch_internodes = 4, twig_internodes = 4;
    double longest = 1.5; // Length of the longest internode, as a multiple of internode_mm.
    double vigour = 2, vigour_old = 2;
    double apical_control = 0.5, apical_control_old = 0.48;
    double old_years = 40;
    double terminal_loss = 0; // Share of lateral shoots whose terminal bud dies.
    double bud_life = 4;      // Years for which a lateral bud stays alive without growing.

    // The fields from here on describe branching. Values named "lateral" hold for all axes but the
    // trunk.
    double angle_deg = 50, lateral_angle_deg = 45;
    double divergence_deg = 137.5, lateral_divergence_deg = 137.5;
    // Azimuth of the laterals at an axis's first node; 90 together with a divergence of 180 makes
    // flat sprays.
    double lateral_start_deg = 0;
    // Standard deviations of the random variation of the divergence and branching angles.
    double divergence_spread_deg = 12, angle_spread_deg = 8;
    double laterals_at_node = 1;
    // Number of laterals at the end of each annual shoot of the trunk; 0: as many as at any other
    // node.
    double whorl = 0;
    // Upward tropism of the trunk, of its branches, of their branches, and of all higher orders;
    // negative: downwards.
    double tropism_trunk = 0.1, tropism_branches = 0.1, tropism_twigs = 0.1, tropism_last = 0.1;
    // Strength with which shoots turn towards light, or towards the free space of a brush.
    double space_weight = 0.35;

    // The fields from here on describe light and shade.
    double cell_mm = 200; // Side of the cubic cells in which shade is recorded.
    // See the fields of the same names in Laws.
    double shade = 0.08, shade_fall = 2, shade_depth = 4;
    // Perception radius of a bud, in cells, and opening angle of its perception cone.
    double sight_cells = 3, sight_angle_deg = 90;
    double shed_below = 0.2, shed_below_old = 0.2;
    // Share of the tree's height, from the ground, in which buds receive no light.
    double clear_share = 0;

    // The fields from here on describe wood.
    double pipe_exponent = 2.3;
    double twig_mm = 3; // Diameter of the outermost twigs.
    // Factor on gravity in the computation of sagging branches; 1: real weight of green wood.
    double weight = 1;
    double flare = 0.5; // Extra width of the trunk at the ground, as a share of its width.
    double ridges = 0;  // Number of ridges that run down the trunk into the roots (RootFlare).
    // Least width of the trunk's annual rings (shown_diameters()); 0: the pipe model alone decides.
    double ring_mm = 0;
    // Rings widen an axis to at most its length above the place, divided by this number, so that a
    // tree that finds little space stays slender. 0: no limit.
    double ring_slenderness = 0;

    // The fields from here on describe leaves, which the shoots of the last `leaf_years` years
    // bear.
    double leaf_years = 1;
    double leaves_at_node = 1;
    double leaf_mm = 80, leaf_width_mm = 45, petiole_mm = 10;
    double leaf_angle_deg = 60; // Angle between leaf and shoot.
    double leaf_is_needle = 0;  // Shape of the leaf: 1 is a needle, 0 a flat blade.
    // Number of needles on an internode, which then are one organ; leaves_at_node is not used.
    // 0: each needle is an organ of its own.
    double shoot_needles = 0;
    double leaf_is_evergreen = 0;
    double leaf_red = 0.25, leaf_green = 0.42, leaf_blue = 0.13; // Leaf colour, sRGB, 0 to 1.
    // Mean colour of the bark of an old trunk, sRGB, 0 to 1; limbs are tinted like it.
    double bark_red = 0.34, bark_green = 0.28, bark_blue = 0.22;
    // Kind of the bark's pictures, one of kBarkNames. Unknown names mean furrows that suit any
    // tree, and so does no name, as in sessions that are older than the kinds.
    std::string bark {};

    bool operator==(Habit const&) const = default;
};

// Describes one numeric field of a habit. `key` is its name in habit files and sessions and must
// never change.
struct HabitNumber {
    char const* key;
    double Habit::*value;
    double least;
    double most;
    bool is_whole = false;
    // True: sessions leave the number out while it is 0, as those did that are older than it.
    bool is_sparse = false;
};
std::span<HabitNumber const> habit_numbers();

// Checks a habit. Fails with a user error for a number out of range; the message names the number's
// key and the range.
Result<void> check_habit(Habit const& habit);

// The growth laws for one year of a tree's life; the first year is 1. Lengths are in millimetres;
// buds compete for light.
Laws growth_laws_in_year(Habit const& habit, int year);

// The growth laws for a year in which buds compete for a brush's markers, with internodes of the
// given length.
Laws brush_growth_laws(Habit const& habit, int year, double internode_mm);

} // namespace tractus::self_organising
