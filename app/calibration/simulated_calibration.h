#pragma once

#include "app/calibration/calibration_controller.h"
#include "engine/base/result.h"
#include "sim/simulated_person.h"
#include "sim/simulated_rig.h"

#include <ostream>
#include <span>
#include <vector>

namespace tractus::calibration {

// Heights in millimetres at which captures are proposed and the simulated user captures. They are
// denser near the bottom: there the string runs at an angle, and a slipped string could be taken
// for one of another length. Empty for procedures with a movement.
std::vector<double> proposed_heights_mm(CalibrationProcedure procedure);

struct SimulatedCalibration {
    CalibrationProcedure procedure = CalibrationProcedure::Height;
    std::vector<double> heights_mm {}; // Heights to capture; empty: proposed_heights_mm().
    // Options of the simulated user. Its seed is also the seed of the simulated devices.
    sim::PersonOptions person {};
    sim::RigGeometry geometry {};
};

// A simulated rig whose surface moves slightly sideways, like that of real rigs. For Tilt, its
// tablet senses the pen nine millimetres above the nib; for other procedures at the nib.
sim::RigGeometry simulated_geometry(CalibrationProcedure procedure = CalibrationProcedure::Height);

// Simulates a user who calibrates the simulated rig, and writes the log that a recording would
// contain, including commands. From before each capture until after it, the user holds the pen
// still on the tablet, which shows that the surface rests. For Travel the pen follows a vertical
// edge, for Latency a slanted one, and for Tilt the nib stays in a dent. The log depends only on
// `calibration`. Fails with a user error for heights out of the rig's reach.
Result<void> write_simulated_calibration(std::ostream& out,
                                         SimulatedCalibration const& calibration);

} // namespace tractus::calibration
