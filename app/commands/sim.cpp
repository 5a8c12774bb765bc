#include "app/commands/sim.h"

#include "app/commands/sim_converters.h"
#include "app/commands/sim_gadget.h"
#include "app/commands/sim_play.h"
#include "app/options/checks.h"
#include "app/terminal/console.h"
#include "drivers/reports/device_address.h"
#include "sim/feature_store.h"
#include "sim/pty_serial_port.h"
#include "sim/serial_board.h"
#include "sim/uhid_device.h"

#include <fmt/core.h>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tractus::commands {

namespace {

struct SimArguments {
    SimPlayArguments play;
    std::vector<std::size_t> devices;
    std::optional<double> rate_hz;
};

// Returns the indices of the devices that the arguments name, by default of all devices.
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
    play::PlaybackSet play;
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

struct SimSerialArguments {
    SimPlayArguments play;
    double rate_hz = 400;
    std::optional<int> full_scale;
    std::string link;
};

class SerialBoardPart final : public play::DevicePart {
public:
    explicit SerialBoardPart(sim::SerialBoard& board)
        : board_(board)
    {
    }

    void begin(Timestamp now) override { board_.begin(now); }
    Timestamp due() const override { return board_.due(); }
    Result<void> play(Timestamp now) override { return board_.play(now); }
    bool is_over(Timestamp now) const override { return board_.is_over(now); }

private:
    sim::SerialBoard& board_;
};

Result<void> play_serial_board(SimSerialArguments const& arguments)
{
    if (auto const address = drivers::parse_device_address(arguments.link); !arguments.link.empty()
        && !(address && std::holds_alternative<drivers::SerialAddress>(*address)))
        return fail(Fault::User,
                    fmt::format("no program would look for a serial line at {}: choose a link in "
                                "/dev, such as /dev/ttyHEIGHT",
                                arguments.link));
    auto const log = TRY(load_sim_play(arguments.play));
    auto heights = TRY(sim::HeightCurve::read(log));
    auto const port = TRY(sim::PtySerialPort::create(arguments.link));
    sim::SerialBoard board(*port, std::move(heights),
                           { .rate_hz = arguments.rate_hz, .full_scale = arguments.full_scale });
    SerialBoardPart part(board);
    terminal::print_error(fmt::format("a board on a serial line: --device {}@max={}\n",
                                      port->address(), board.full_scale()));
    play::PlaybackSet play;
    play.devices = { port.get() };
    play.parts = { &part };
    return run_sim_play(std::move(play), arguments.play);
}

void add_serial_command(CLI::App& sim, options::Action& action)
{
    auto* const command = sim.add_subcommand(
        "serial", "A board on a serial line that prints a recording's heights; needs no root");
    auto arguments = std::make_shared<SimSerialArguments>();
    add_sim_play_options(*command, arguments->play);
    command->add_option("--rate", arguments->rate_hz, "How many lines it prints per second")
        ->type_name("HZ")
        ->check(options::number(0.1, 10'000))
        ->capture_default_str();
    command
        ->add_option("--max", arguments->full_scale,
                     "The number that it prints at the full scale of the recording's sensor; "
                     "without it, what that sensor read there")
        ->type_name("NUMBER")
        ->check(options::whole_number(1, 2'000'000'000));
    command
        ->add_option("--link", arguments->link,
                     "A symbolic link to the line, such as /dev/ttyHEIGHT, by which it is found "
                     "again when it is plugged in anew")
        ->type_name("FILE");
    command->footer(
        "It prints the address to read it by, of a pseudo-terminal, which every command takes\n"
        "for a serial port: the heights begin to move when a program opens it. Ctrl-C unplugs\n"
        "it. Started again, it usually gets the same address; --link makes sure of that, and\n"
        "needs root for a link in /dev, where the station looks for serial lines.");
    command->callback(
        [arguments, &action] { action = [arguments] { return play_serial_board(*arguments); }; });
}

} // namespace

void add_sim_command(CLI::App& root, options::Action& action)
{
    auto* const command
        = root.add_subcommand("sim", "Play a tablet and a height sensor to the kernel");
    command->require_subcommand(1);
    add_uhid_command(*command, action);
    add_serial_command(*command, action);
    add_sim_gadget_command(*command, action);
    add_sim_converter_commands(*command, action);
}

} // namespace tractus::commands
