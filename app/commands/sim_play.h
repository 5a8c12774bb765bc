#pragma once

#include "app/options/action.h"
#include "app/play/device_parts.h"
#include "drivers/logs/log.h"
#include "engine/base/result.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace tractus::commands {

// Options that the ways of "tractus sim" that play a recording or a script share.
struct SimPlayArguments {
    std::string log;
    std::string script;
    std::string model = "broadleaf";
    bool stay = false;
    bool repeat = false;
};

void add_sim_play_options(CLI::App& command, SimPlayArguments& arguments);

// The recording to play: what was named, or what "tractus record --simulate" would make of the
// script. Fails, as the user's fault, if there are no reports in it.
Result<drivers::Log> load_sim_play(SimPlayArguments const& arguments);

// The reports of one of the log's devices, their times since the log's first report; or in even
// steps, so many per second. The log must outlive them.
std::function<play::NextReport()> reports_of(drivers::Log const& log, std::size_t device,
                                             std::optional<double> rate_hz);

// Plays until it is over or a signal asks to stop, and says on standard error when it begins and
// how it went.
Result<void> run_sim_play(play::DevicePlay play, SimPlayArguments const& arguments);

} // namespace tractus::commands
