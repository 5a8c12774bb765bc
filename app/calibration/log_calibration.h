#pragma once

#include "app/calibration/calibration_controller.h"
#include "drivers/logs/log.h"
#include "engine/base/result.h"

#include <string>
#include <string_view>

namespace tractus::calibration {

// The word in front of a calibration's commands in a log's tool lines.
constexpr std::string_view kCalibrateTool = "calibrate";

// Does a recorded calibration again, as its commands in the log say. The same log and options give
// the same outcome. Fails as the controller does; messages name the log.
Result<CalibrationOutcome> calibrate_from_log(drivers::Log const& log,
                                              CalibrationController::Options options,
                                              std::string const& date);

} // namespace tractus::calibration
