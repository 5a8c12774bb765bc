#pragma once

#include "calib/calibrate.h"
#include "calib/rig.h"
#include "calib/zeroing.h"

#include <span>
#include <string>

namespace tractus::calibration {

// Texts that a person reads after a calibration: lines that end in a line break.

std::string describe(calib::HeightCalibration const& calibration, calib::Rig const& rig);
std::string describe(calib::TravelFit const& fit);
std::string describe(calib::LatencyFit const& fit, calib::Rig const& rig);
std::string describe(calib::TiltFit const& fit);
std::string describe(calib::HeightCheck const& check);

// `before` is the rig that was zeroed.
std::string describe(calib::Zeroing const& zeroing, calib::Rig const& before,
                     std::span<calib::HeightCapture const> captures);

// Says what is at stake where nobody has told why heights are off, and how to tell it.
std::string describe_question(calib::Zeroing const& zeroing);

// Heights in millimetres as "0.0 to 400.1 mm", in no line of its own.
std::string describe_heights(double low_mm, double high_mm);

} // namespace tractus::calibration
