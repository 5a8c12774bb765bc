#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <array>
#include <cstddef>
#include <limits>

namespace tractus::self_organising {

// Tropism, divergence and branching angle differ by the order of the axis: 0 for the trunk, and the
// last number holds for that order and all higher ones.
template<typename T> struct ByOrder {
    static constexpr std::size_t kOrders = 4;
    std::array<T, kOrders> values {};

    ByOrder() = default;
    ByOrder(T const& value) // NOLINT(google-explicit-constructor): the same for all orders.
    {
        values.fill(value);
    }
    ByOrder(T const& trunk, T const& laterals)
        : values { trunk, laterals, laterals, laterals }
    {
    }

    T const& at(std::size_t order) const { return values[order < kOrders ? order : kOrders - 1]; }

    bool operator==(ByOrder const&) const = default;
};

// The laws of one step of growth, usually a year: space colonisation (Runions, Lane, Prusinkiewicz
// 2007), shadow propagation, the extended Borchert-Honda model and shedding (Palubicki et al.
// 2009), and the pipe model (Shinozaki et al. 1964). Lengths are in a unit of the caller's choice;
// z is up.
struct Laws {
    enum class Environment {
        Space, // Buds compete for markers.
        Light, // Buds compete for light; each shades the cells below it.
    } environment
        = Environment::Space;
    double internode = 1;

    // What a bud perceives: a cone about its direction, by its whole opening angle.
    double perception_radius = 5;
    double perception_angle_deg = 90;
    double occupancy_radius = 2; // A marker nearer than this to any bud is used up.

    double cell = 1;       // Side of the cells in which shade is kept.
    double shade = 0.2;    // Shade that a bud casts on its own cell,
    double shade_fall = 2; // divided by this with each layer of cells below,
    int shade_depth = 5;   // down to this layer.
    double full_light = 1; // What a bud receives without shade.
    // Buds below this height receive nothing. Default: there is no ground.
    double ground = -std::numeric_limits<double>::infinity();

    double apical_control = 0.5; // Lambda: above 0.5 the axis wins over its laterals.
    double vigour = 2;           // Alpha: the base's vigour for each unit that buds receive.
    double space_weight = 0.6;   // Pull towards the bud's best direction on each internode.
    ByOrder<double> tropism_weight = 0.1; // Likewise towards tropism_direction; negative: away.
    Vec3 tropism_direction = Vec3::UnitZ();
    ByOrder<int> most_internodes = 4; // Longest shoot of one step.
    double longest = 1.5;             // Longest internode, as a multiple of `internode`.

    ByOrder<double> divergence_deg = 137.5;   // From one node of an axis to the next.
    ByOrder<double> divergence_start_deg = 0; // Added to all nodes of an axis.
    ByOrder<double> branching_angle_deg = 45; // Between a lateral bud and the axis that bears it.
    // Standard deviations by which lateral buds stray from both, by chance (Surroundings::seed).
    double divergence_spread_deg = 0;
    double angle_spread_deg = 0;
    int laterals_at_node = 1; // Lateral buds at each node; 0 to 8.
    int whorl = 0;            // At the last node of a shoot of order 0; 0: as at any.
    double terminal_loss
        = 0;          // Probability that a lateral shoot's terminal bud dies in its first winter.
    int bud_life = 0; // Steps after which a lateral bud that has not grown dies; 0: never.

    double shed_below = 0; // A lateral branch that receives less than this per internode dies.

    double pipe_exponent = 2.3;   // e in d^e = sum of d_child^e.
    double twig_diameter = 0.05;  // Of internodes that bear no other.
    bool keeps_dead_wood = false; // Shed branches leave their share in what bore them.

    std::size_t most_nodes = 2'000'000; // A tree that would have more fails to grow.

    bool operator==(Laws const&) const = default;
};

// Fails, as the user's fault, for laws that are out of range: what, where and the range.
Result<void> check_laws(Laws const& laws);

} // namespace tractus::self_organising
