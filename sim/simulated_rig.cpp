#include "sim/simulated_rig.h"

#include <array>
#include <utility>

namespace tractus::sim {

std::vector<ArrivedReport> SimulatedRun::in_order_of_arrival() const
{
    return sim::in_order_of_arrival(std::array { &tablet, &height });
}

SimulatedRun simulate_rig(Hand const& hand, SimulatedRigOptions const& options)
{
    auto tablet_options = options.tablet;
    auto height_options = options.height;
    tablet_options.seed = height_options.seed = options.seed;

    auto tablet = simulate_tablet(hand, options.geometry, tablet_options);
    auto rig = true_rig(options.geometry);
    rig.tablet_latency = tablet_options.timing.latency;
    auto height = simulate_height(hand, options.geometry, height_options);
    rig.height_latency = height.latency;
    return {
        .tablet = std::move(tablet.device),
        .height = std::move(height.device),
        .rig = rig,
        .truth = std::move(tablet.truth),
    };
}

} // namespace tractus::sim
