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

// Options shared by those "tractus sim" commands that play a recording or a script.
struct SimPlayArguments {
    std::string log;
    std::string script;
    std::string model = "broadleaf";
    bool is_unkind = false;
    bool stay = false;
    bool repeat = false;
};

void add_sim_play_options(CLI::App& command, SimPlayArguments& arguments);

// The recording to play: the named log, or the log that "tractus record --simulate" would make of
// the script. Fails with a user error if it contains no reports.
Result<drivers::Log> load_sim_play(SimPlayArguments const& arguments);

// The reports of one of the log's devices, with times since the log's first report, or at a
// constant rate of `rate_hz`. The log must outlive the result.
std::function<play::NextReport()> reports_of(drivers::Log const& log, std::size_t device,
                                             std::optional<double> rate_hz);

// Plays until the end or a signal, and prints on standard error when it begins and how it went.
Result<void> run_sim_play(play::PlaybackSet play, SimPlayArguments const& arguments);

} // namespace tractus::commands
