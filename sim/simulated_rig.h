#pragma once

#include "calib/rig.h"
#include "sim/hand.h"
#include "sim/rig_geometry.h"
#include "sim/simulated_device.h"
#include "sim/simulated_height.h"
#include "sim/simulated_tablet.h"

#include <cstdint>
#include <vector>

namespace tractus::sim {

struct SimulatedRigOptions {
    RigGeometry geometry {};
    TabletOptions tablet {}; // Its seed and the height sensor's are the rig's.
    HeightOptions height {};
    std::uint64_t seed = 1;
};

// Results of a hand's drawing on a rig: the bytes, and the truth beside them.
struct SimulatedRun {
    SimulatedDevice tablet {};
    SimulatedDevice height {};
    calib::Rig rig {};             // Rig as a user's perfect calibration would have it.
    std::vector<TrueTip> truth {}; // One per report of the tablet.

    // Device 0 is the tablet, 1 the height sensor.
    std::vector<ArrivedReport> in_order_of_arrival() const;
};

// A pure function: the same hand and options give the same bytes.
SimulatedRun simulate_rig(Hand const& hand, SimulatedRigOptions const& options);

} // namespace tractus::sim
