#include "app/calibration/log_calibration.h"

#include <fmt/core.h>

namespace tractus::calibration {

static Result<CalibrationOutcome>
run(drivers::Log const& log, CalibrationController::Options options, std::string const& date)
{
    auto controller = TRY(CalibrationController::create(log.devices, std::move(options)));
    std::size_t next_tool = 0;
    auto const give_commands_before = [&](std::size_t position) -> Result<void> {
        for (; next_tool < log.tools.size() && log.tools[next_tool].position <= position;
             ++next_tool) {
            auto const& line = log.tools[next_tool];
            if (line.tool == kCalibrateTool)
                TRY(controller.command(line.time, line.arguments));
        }
        return {};
    };
    drivers::LogCursor cursor(log);
    TRY(give_commands_before(0));
    while (auto const* const report = TRY(cursor.next())) {
        controller.push(report->device, report->time, report->bytes);
        TRY(give_commands_before(cursor.position()));
    }
    return controller.finish(date);
}

Result<CalibrationOutcome> calibrate_from_log(drivers::Log const& log,
                                              CalibrationController::Options options,
                                              std::string const& date)
{
    auto outcome = run(log, std::move(options), date);
    if (!outcome)
        return fail(outcome.error().fault,
                    fmt::format("{}: {}", log.name, outcome.error().message));
    return outcome;
}

} // namespace tractus::calibration
