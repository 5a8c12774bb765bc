#pragma once

#include "app/calibration/calibration_controller.h"
#include "engine/base/result.h"

#include <filesystem>
#include <string>

namespace tractus::calibration {

// Saves the rig's file and keeps the old one as .bak. After Height, also saves the fit's plots
// beside it: my.rig.svg beside my.rig.toml. Returns a line about each file written. Fails with a
// user error if a file cannot be written.
Result<std::string> save_calibration(CalibrationOutcome const& outcome,
                                     std::filesystem::path const& rig);

// Local date for a calibration's record, such as "2026-11-22".
std::string today();

} // namespace tractus::calibration
