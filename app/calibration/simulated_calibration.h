#pragma once

#include "app/calibration/calibration_controller.h"
#include "engine/base/result.h"
#include "sim/simulated_person.h"
#include "sim/simulated_rig.h"

#include <ostream>
#include <span>
#include <vector>

namespace tractus::calibration {

// The heights at which the simulated person captures, and which the program proposes: closer
// together at the bottom, where a string runs aslant and a slip would pass for another string.
// Millimetres; none for movements.
std::vector<double> proposed_heights_mm(CalibrationProcedure procedure);

struct SimulatedCalibration {
    CalibrationProcedure procedure = CalibrationProcedure::Height;
    std::vector<double> heights_mm {}; // Empty: the proposed ones.
    sim::PersonOptions person {};      // The devices have its seed, too.
    sim::RigGeometry geometry {};
};

// A rig whose surface moves a little aside, as real ones do. Of Tilt, one whose tablet sees the pen
// nine millimetres above its nib; for the others it is seen where it is.
sim::RigGeometry simulated_geometry(CalibrationProcedure procedure = CalibrationProcedure::Height);

// Lets a simulated person calibrate the simulated rig, and writes the log that a recording of it
// would have given, commands included. At each height the person holds the pen still on the tablet
// as well, as a sign that the surface rests. Travel follows an upright edge, latency an inclined
// one, and for a tilt the nib stays in a dent. A pure function. Fails, as the user's fault, for
// heights out of the rig's reach.
Result<void> write_simulated_calibration(std::ostream& out,
                                         SimulatedCalibration const& calibration);

} // namespace tractus::calibration
