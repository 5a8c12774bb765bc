#pragma once

#include "calib/calibrate.h"
#include "calib/rig.h"

#include <string>

namespace tractus {

// What a person reads after a calibration: lines that end in a line break.

std::string describe(HeightCalibration const& calibration, Rig const& rig);
std::string describe(TravelFit const& fit);
std::string describe(LatencyFit const& fit, Rig const& rig);
std::string describe(HeightCheck const& check);

} // namespace tractus
