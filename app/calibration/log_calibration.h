#pragma once

#include "app/calibration/calibration_controller.h"
#include "drivers/logs/log.h"
#include "engine/base/result.h"

#include <string>
#include <string_view>

namespace tractus::calibration {

// First word of a calibration's commands in a log's tool lines.
constexpr std::string_view kCalibrateTool = "calibrate";

// Repeats a recorded calibration with the commands in its log. Deterministic: the same log and
// options give the same outcome. Fails like CalibrationController; messages contain the log's name.
Result<CalibrationOutcome> calibrate_from_log(drivers::Log const& log,
                                              CalibrationController::Options options,
                                              std::string const& date);

} // namespace tractus::calibration
