#pragma once

#include "app/calibration/calibration_controller.h"
#include "engine/base/result.h"
#include "sim/simulated_person.h"
#include "sim/simulated_rig.h"

#include <ostream>
#include <span>
#include <vector>

namespace tractus::calibration {

// Heights in millimetres that the program proposes, and at which the simulated user captures. They
// are denser at the bottom, where a string runs at an angle and a slip could pass for a different
// string length. Empty for movements.
std::vector<double> proposed_heights_mm(CalibrationProcedure procedure);

struct SimulatedCalibration {
    CalibrationProcedure procedure = CalibrationProcedure::Height;
    std::vector<double> heights_mm {}; // Heights to capture; empty: the proposed heights.
    // Options of the simulated user; the seed is also used for the devices.
    sim::PersonOptions person {};
    sim::RigGeometry geometry {};
};

// A rig whose surface moves slightly sideways, like real ones. For Tilt its tablet senses the pen
// nine millimetres above the nib; otherwise at the nib.
sim::RigGeometry simulated_geometry(CalibrationProcedure procedure = CalibrationProcedure::Height);

// Simulates a user who calibrates the simulated rig, and writes the log that a recording would
// contain, including commands. At each height the user also holds the pen still on the tablet, as a
// sign that the surface rests. Travel follows a vertical edge, latency a slanted one, and for tilt
// the nib stays in a dent. A pure function. Fails with a user error for heights out of the rig's
// reach.
Result<void> write_simulated_calibration(std::ostream& out,
                                         SimulatedCalibration const& calibration);

} // namespace tractus::calibration
