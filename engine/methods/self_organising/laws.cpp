#include "engine/methods/self_organising/laws.h"

#include <cmath>
#include <fmt/core.h>

namespace tractus::self_organising {

namespace {

Result<void> check_range(char const* name, double value, double least, double most)
{
    if (value >= least && value <= most)
        return {};
    return fail(
        Fault::User,
        fmt::format("{} is {:g}: give a number from {:g} to {:g}", name, value, least, most));
}

Result<void> check_range(char const* name, ByOrder<double> const& by_order, double least,
                         double most)
{
    for (auto const value : by_order.values)
        TRY(check_range(name, value, least, most));
    return {};
}

Result<void> check_environment(Laws const& laws)
{
    constexpr double kLargest = 1e6;
    TRY(check_range("internode", laws.internode, 1e-6, kLargest));
    TRY(check_range("perception_radius", laws.perception_radius, 1e-6, kLargest));
    TRY(check_range("perception_angle", laws.perception_angle_deg, 0, 360));
    TRY(check_range("occupancy_radius", laws.occupancy_radius, 0, kLargest));
    TRY(check_range("cell", laws.cell, 1e-6, kLargest));
    if (laws.environment == Laws::Environment::Light)
        TRY(check_range("perception_radius in cells", laws.perception_radius / laws.cell, 0, 20));
    TRY(check_range("shade", laws.shade, 0, kLargest));
    TRY(check_range("shade_fall", laws.shade_fall, 1e-3, kLargest));
    TRY(check_range("shade_depth", laws.shade_depth, 0, 50));
    return check_range("full_light", laws.full_light, 0, kLargest);
}

Result<void> check_shoots(Laws const& laws)
{
    TRY(check_range("apical_control", laws.apical_control, 0, 1));
    TRY(check_range("vigour", laws.vigour, 0, 1e3));
    TRY(check_range("space_weight", laws.space_weight, 0, 1e3));
    TRY(check_range("tropism_weight", laws.tropism_weight, -1e3, 1e3));
    for (auto const most : laws.most_internodes.values)
        TRY(check_range("most_internodes", most, 0, 1000));
    TRY(check_range("longest", laws.longest, 0, 1e3));
    TRY(check_range("divergence", laws.divergence_deg, -360, 360));
    TRY(check_range("divergence_start", laws.divergence_start_deg, -360, 360));
    TRY(check_range("branching_angle", laws.branching_angle_deg, 0, 180));
    TRY(check_range("divergence_spread", laws.divergence_spread_deg, 0, 180));
    TRY(check_range("angle_spread", laws.angle_spread_deg, 0, 90));
    TRY(check_range("laterals_at_node", laws.laterals_at_node, 0, 8));
    TRY(check_range("whorl", laws.whorl, 0, 8));
    TRY(check_range("terminal_loss", laws.terminal_loss, 0, 1));
    return check_range("bud_life", laws.bud_life, 0, 1000);
}

} // namespace

Result<void> check_laws(Laws const& laws)
{
    TRY(check_environment(laws));
    TRY(check_shoots(laws));
    TRY(check_range("shed_below", laws.shed_below, 0, 1e6));
    TRY(check_range("pipe_exponent", laws.pipe_exponent, 1, 10));
    TRY(check_range("twig_diameter", laws.twig_diameter, 1e-6, 1e6));
    if (!laws.tropism_direction.allFinite())
        return fail(Fault::User, "tropism_direction is no direction: give three numbers");
    return {};
}

} // namespace tractus::self_organising
