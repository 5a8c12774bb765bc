#include "app/verbs/sim.h"

#include "app/console.h"
#include "app/device_playback.h"
#include "app/verbs/checks.h"
#include "app/verbs/sim_converters.h"
#include "app/verbs/sim_gadget.h"
#include "sim/feature_store.h"
#include "sim/uhid_device.h"

#include <atomic>
#include <csignal>
#include <fmt/core.h>
#include <memory>
#include <string>
#include <vector>

namespace tractus {

namespace {

// What every way of playing devices takes.
struct Arguments {
    std::string log;
    std::vector<std::size_t> devices;
    PlaybackOptions playback;
};

std::atomic<bool> stop_asked = false;

void ask_to_stop(int)
{
    stop_asked = true;
}

// The devices that were named, or all.
Result<std::vector<std::size_t>> choose_devices(Log const& log, Arguments const& arguments)
{
    std::vector<std::size_t> chosen = arguments.devices;
    for (std::size_t i = 0; arguments.devices.empty() && i < log.devices.size(); ++i)
        chosen.push_back(i);
    for (auto const device : chosen)
        if (device >= log.devices.size())
            return fail(Fault::User,
                        fmt::format("{} has no device {}: it has {}", log.name, device,
                                    log.devices.size()));
    return chosen;
}

Result<void> play_through_uhid(Arguments const& arguments)
{
    auto const log = TRY(read_log(arguments.log));
    auto const chosen = TRY(choose_devices(log, arguments));
    std::vector<PlayedDevice> played;
    for (auto const device : chosen) {
        auto made = TRY(UhidDevice::create(log.devices[device], remember_features()));
        print_error(fmt::format("playing {}\n", log.devices[device].name));
        played.push_back({ device, std::move(made) });
    }
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    auto const counts = TRY(play_devices(log, played, arguments.playback, stop_asked));
    return print_out(fmt::format("{}: {} reports{}\n", arguments.log, counts.reports,
                                 counts.lost ? fmt::format(", {} lost", counts.lost) : ""));
}

void add_playback_options(CLI::App& verb, Arguments& arguments)
{
    verb.add_option("LOG", arguments.log,
                    "What to play: a .tractus-log (\"tractus record --simulate\" makes one), or "
                    "anybody's hid-recorder file")
        ->required();
    verb.add_option("--device", arguments.devices,
                    "Which devices of the log, counted from 0; without it, all of them")
        ->type_name("N...");
    auto* const rate = verb.add_option("--rate", arguments.playback.rate_hz,
                                       "Send the reports in even steps, so many per second, and "
                                       "not as they were recorded")
                           ->type_name("HZ")
                           ->check(number(0.01, 1e6));
    verb.add_flag("--at-once", arguments.playback.at_once,
                  "Send the reports as fast as the kernel takes them")
        ->excludes(rate);
    verb.add_flag("--stay", arguments.playback.stay,
                  "Stay plugged in after the last report, until Ctrl-C");
}

} // namespace

void add_sim_verb(CLI::App& root, Action& action)
{
    auto* const verb
        = root.add_subcommand("sim", "Play a tablet and a height sensor to the kernel");
    verb->require_subcommand(1);
    auto arguments = std::make_shared<Arguments>();
    auto* const uhid
        = verb->add_subcommand("uhid", "As HID devices of this computer, through /dev/uhid");
    add_playback_options(*uhid, *arguments);
    uhid->footer(
        "The kernel and every program take the devices for real ones; \"tractus devices\" lists\n"
        "them. Reports are sent from when somebody reads each of the devices, and when the last\n"
        "has been taken, the devices are unplugged. Needs root, or the right to use /dev/uhid.");
    uhid->callback(
        [arguments, &action] { action = [arguments] { return play_through_uhid(*arguments); }; });
    add_sim_gadget_verb(*verb, action);
    add_sim_converter_verbs(*verb, action);
}

} // namespace tractus
