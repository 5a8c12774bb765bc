#include "app/commands/sim.h"

#include "app/commands/sim_converters.h"
#include "app/commands/sim_gadget.h"
#include "app/commands/sim_play.h"
#include "app/options/checks.h"
#include "app/terminal/console.h"
#include "sim/feature_store.h"
#include "sim/uhid_device.h"

#include <fmt/core.h>
#include <memory>
#include <vector>

namespace tractus::commands {

namespace {

struct SimArguments {
    SimPlayArguments play;
    std::vector<std::size_t> devices;
    std::optional<double> rate_hz;
};

// The devices that were named, by default all.
Result<std::vector<std::size_t>> choose_devices(drivers::Log const& log,
                                                SimArguments const& arguments)
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

Result<void> play_through_uhid(SimArguments const& arguments)
{
    auto const log = TRY(load_sim_play(arguments.play));
    auto const chosen = TRY(choose_devices(log, arguments));
    std::vector<std::unique_ptr<sim::KernelDevice>> devices;
    std::vector<std::unique_ptr<play::DevicePart>> parts;
    play::DevicePlay play;
    for (auto const index : chosen) {
        auto device = TRY(sim::UhidDevice::create(log.devices[index], sim::remember_features()));
        terminal::print_error(fmt::format("playing {}\n", log.devices[index].name));
        parts.push_back(
            std::make_unique<play::ReportPart>(*device, reports_of(log, index, arguments.rate_hz)));
        play.devices.push_back(device.get());
        play.parts.push_back(parts.back().get());
        devices.push_back(std::move(device));
    }
    return run_sim_play(std::move(play), arguments.play);
}

void add_uhid_command(CLI::App& sim, options::Action& action)
{
    auto* const command
        = sim.add_subcommand("uhid", "As HID devices of this computer, through /dev/uhid");
    auto arguments = std::make_shared<SimArguments>();
    add_sim_play_options(*command, arguments->play);
    command
        ->add_option("--device", arguments->devices,
                     "Which devices of the recording, counted from 0; without it, all of them")
        ->type_name("N...");
    command
        ->add_option("--rate", arguments->rate_hz,
                     "Send each device's reports in even steps, so many per second, and not as "
                     "they were recorded")
        ->type_name("HZ")
        ->check(options::number(0.01, 1e6));
    command->footer(
        "The kernel and every program take the devices for real ones; \"tractus devices\" lists\n"
        "them. Reports are sent from when somebody reads each of the devices, and when the last\n"
        "has been taken, the devices are unplugged. Needs root, or the right to use /dev/uhid.");
    command->callback(
        [arguments, &action] { action = [arguments] { return play_through_uhid(*arguments); }; });
}

} // namespace

void add_sim_command(CLI::App& root, options::Action& action)
{
    auto* const command
        = root.add_subcommand("sim", "Play a tablet and a height sensor to the kernel");
    command->require_subcommand(1);
    add_uhid_command(*command, action);
    add_sim_gadget_command(*command, action);
    add_sim_converter_commands(*command, action);
}

} // namespace tractus::commands
