#pragma once

#include "app/calibration/calibration_controller.h"
#include "engine/base/result.h"

#include <filesystem>
#include <string>

namespace tractus::calibration {

// Saves the rig's file (the old one is kept as .bak) and, after Height, the fit's plots beside it:
// my.rig.svg beside my.rig.toml. Returns a line about each file written. Fails with a user error if
// one cannot be written.
Result<std::string> save_calibration(CalibrationOutcome const& outcome,
                                     std::filesystem::path const& rig);

// Local date for a calibration's record: "2026-11-22".
std::string today();

} // namespace tractus::calibration
