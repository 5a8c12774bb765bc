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

// Options shared by the "tractus sim" commands that play a recording or a script.
struct SimPlayArguments {
    std::string log;
    std::string script;
    std::string model = "broadleaf";
    bool is_unkind = false;
    bool stay = false;
    bool repeat = false;
};

void add_sim_play_options(CLI::App& command, SimPlayArguments& arguments);

// Returns the recording to play: the log that the arguments name, or the log that "tractus record
// --simulate" would make from the script. Fails with a user error if it contains no reports.
Result<drivers::Log> load_sim_play(SimPlayArguments const& arguments);

// Returns a function that supplies the reports of one device of the log, with times since the log's
// first report or, with `rate_hz`, at a constant rate. The log must outlive the result.
std::function<play::NextReport()> reports_of(drivers::Log const& log, std::size_t device,
                                             std::optional<double> rate_hz);

// Plays until the end or a signal, and prints a line on standard error at the start and at the end.
Result<void> run_sim_play(play::PlaybackSet play, SimPlayArguments const& arguments);

} // namespace tractus::commands
