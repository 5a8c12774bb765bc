#pragma once

#include "app/calibration/calibration_controller.h"
#include "engine/base/result.h"

#include <filesystem>
#include <string>

namespace tractus::calibration {

// Writes the rig's file (what was there stays as .bak) and, after Height, the fit's plots beside
// it: my.rig.svg beside my.rig.toml. Says what was written, a line each. Fails, as the user's
// fault, if one cannot be written.
Result<std::string> save_calibration(CalibrationOutcome const& outcome,
                                     std::filesystem::path const& rig);

// The date here, for a calibration's record: "2026-11-22".
std::string today();

} // namespace tractus::calibration
