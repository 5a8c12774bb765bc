#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <array>
#include <cstddef>
#include <limits>

namespace tractus::self_organising {

// A value that depends on the order of an axis, such as a tropism or an angle. Order 0 is the
// trunk; the last value holds for all higher orders.
template<typename T> struct ByOrder {
    static constexpr std::size_t kOrders = 4;
    std::array<T, kOrders> values {};

    ByOrder() = default;
    ByOrder(T const& value) // NOLINT(google-explicit-constructor): one value converts to the same
                            // value for all orders.
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

// The laws of one growth step, usually a year: space colonisation (Runions, Lane, Prusinkiewicz
// 2007), shadow propagation, the extended Borchert-Honda model and shedding (Palubicki et al.
// 2009), and the pipe model (Shinozaki et al. 1964). The caller chooses the unit of length; z is
// up.
struct Laws {
    enum class Environment {
        Space, // Buds compete for markers of free space.
        Light, // Buds compete for light; each bud shades the cells below it.
    } environment
        = Environment::Space;
    double internode = 1;

    // A bud perceives light or markers in a cone about its direction: `perception_radius` is the
    // cone's length, `perception_angle_deg` its full opening angle.
    double perception_radius = 5;
    double perception_angle_deg = 90;
    double occupancy_radius = 2; // A marker nearer than this to any bud is used up.

    double cell = 1;       // Side of the cubic cells in which shade is recorded.
    double shade = 0.2;    // Shade that a bud adds to its own cell.
    double shade_fall = 2; // Ratio of the shade in one layer of cells to that in the layer below.
    int shade_depth = 5;   // Number of layers below a bud that it shades.
    double full_light = 1; // Light that an unshaded bud receives.
    // Buds below this height receive no light. Default: no limit.
    double ground = -std::numeric_limits<double>::infinity();

    // Lambda of the Borchert-Honda model: above 0.5 the main axis is favoured over its laterals.
    double apical_control = 0.5;
    // Alpha of the Borchert-Honda model: vigour at the base per unit of light or space received.
    double vigour = 2;
    // Weight of the bud's preferred direction in the direction of each new internode.
    double space_weight = 0.6;
    // Weight of tropism_direction in the direction of each new internode; negative: away from it.
    ByOrder<double> tropism_weight = 0.1;
    Vec3 tropism_direction = Vec3::UnitZ();
    ByOrder<int> most_internodes = 4; // Maximum number of internodes of a shoot in one step.
    double longest = 1.5;             // Longest internode, as a multiple of `internode`.

    ByOrder<double> divergence_deg = 137.5; // Divergence angle between successive nodes of an axis.
    ByOrder<double> divergence_start_deg = 0; // Azimuth that is added at all nodes of an axis.
    ByOrder<double> branching_angle_deg = 45; // Angle between a lateral bud and its parent axis.
    // Standard deviations of the random variation of divergence and branching angle
    // (Surroundings::seed).
    double divergence_spread_deg = 0;
    double angle_spread_deg = 0;
    int laterals_at_node = 1; // Number of lateral buds at each node, 0 to 8.
    // Number of lateral buds at the last node of each trunk shoot; 0: as many as at any other node.
    int whorl = 0;
    // Probability that the terminal bud of a lateral shoot dies in its first winter.
    double terminal_loss = 0;
    int bud_life = 0; // Number of steps after which a dormant lateral bud dies; 0: it never dies.

    // A lateral branch that receives less light or space than this per internode dies.
    double shed_below = 0;

    // Exponent e of the pipe model: diameter^e = sum of the children's diameter^e.
    double pipe_exponent = 2.3;
    double twig_diameter = 0.05; // Diameter of internodes without children.
    // True: shed branches still count towards the width of the wood below them.
    bool keeps_dead_wood = false;

    std::size_t most_nodes = 2'000'000; // Limit on the number of nodes; growing beyond it fails.

    bool operator==(Laws const&) const = default;
};

// Checks growth laws. Fails with a user error for a value out of range; the message names the
// value's field and the range.
Result<void> check_laws(Laws const& laws);

} // namespace tractus::self_organising
