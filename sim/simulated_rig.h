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
    TabletOptions tablet {}; // The seeds of tablet and height sensor are replaced by the rig's.
    HeightOptions height {};
    std::uint64_t seed = 1;
};

// Result of a simulated hand that draws on a rig: the devices' reports and the true positions.
struct SimulatedRun {
    SimulatedDevice tablet {};
    SimulatedDevice height {};
    calib::Rig rig {};             // Rig as a perfect calibration would find it.
    std::vector<TrueTip> truth {}; // True tips, one for each report of the tablet.

    // Returns all reports in order of arrival. Device 0 is the tablet, 1 the height sensor.
    std::vector<ArrivedReport> in_order_of_arrival() const;
};

// Simulates a hand that draws on a rig. Equal hands and options give equal reports, byte by byte.
SimulatedRun simulate_rig(Hand const& hand, SimulatedRigOptions const& options);

} // namespace tractus::sim
