#pragma once

#include "calib/calibrate.h"
#include "calib/rig.h"
#include "calib/zeroing.h"

#include <span>
#include <string>

namespace tractus::calibration {

// Texts that report a calibration to the user; each line ends in a line break.

std::string describe(calib::HeightCalibration const& calibration, calib::Rig const& rig);
std::string describe(calib::TravelFit const& fit);
std::string describe(calib::LatencyFit const& fit, calib::Rig const& rig);
std::string describe(calib::TiltFit const& fit);
std::string describe(calib::HeightCheck const& check);

// Describes the result of zeroing. `before` is the rig as it was before zeroing.
std::string describe(calib::Zeroing const& zeroing, calib::Rig const& before,
                     std::span<calib::HeightCapture const> captures);

// Asks the user why height zero is off: explains what depends on the answer, and how to give it.
std::string describe_question(calib::Zeroing const& zeroing);

// Formats a range of heights in millimetres as "0.0 to 400.1 mm", without a line break.
std::string describe_heights(double low_mm, double high_mm);

} // namespace tractus::calibration
