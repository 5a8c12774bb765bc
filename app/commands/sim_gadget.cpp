#include "app/commands/sim_gadget.h"

#include "app/commands/sim_play.h"
#include "app/options/checks.h"
#include "app/play/played_height_sensor.h"
#include "app/terminal/console.h"
#include "drivers/device_kind.h"
#include "sim/gadget_hid.h"
#include "sim/usb_gadget.h"

#include <algorithm>
#include <fmt/core.h>
#include <memory>
#include <string>
#include <vector>

namespace tractus::commands {

namespace {

// USB ids for private tests: pid.codes reserves 1209:0001 to 1209:0010 for them.
constexpr std::uint16_t kTestVendor = 0x1209;
constexpr std::uint16_t kSensorProduct = 0x0002;
constexpr std::uint16_t kPenProduct = 0x0003;

struct SimGadgetArguments {
    SimPlayArguments play;
    std::string what = "both";
    std::optional<double> rate_hz;
    std::string port;
    std::string name = "tractus";
};

// Functions of the USB gadget, which must outlive them.
struct Functions {
    std::vector<std::unique_ptr<sim::GadgetHid>> pens;
    std::vector<std::unique_ptr<play::ReportPart>> pen_parts;
    std::unique_ptr<play::PlayedHeightSensor> sensor;

    play::PlaybackSet play() const
    {
        play::PlaybackSet play;
        for (auto const& pen : pens)
            play.devices.push_back(pen.get());
        for (auto const& part : pen_parts)
            play.parts.push_back(part.get());
        if (sensor) {
            play.devices.push_back(&sensor->device());
            play.parts.push_back(sensor.get());
        }
        return play;
    }
};

std::vector<std::size_t> pens_in(drivers::Log const& log)
{
    std::vector<std::size_t> pens;
    for (std::size_t i = 0; i < log.devices.size(); ++i) {
        bool const is_pen
            = drivers::describe_device(log.devices[i]).kind == drivers::DeviceKind::Pen;
        bool const is_silent = std::none_of(log.records.begin(), log.records.end(),
                                            [&](auto const& record) { return record.device == i; });
        if (is_pen && !is_silent)
            pens.push_back(i);
    }
    return pens;
}

// Returns the gadget's USB identity. A recorded tablet keeps its own ids, as programs recognise it
// by them; a simulated tablet or a sensor without a tablet gets the test ids.
sim::UsbGadgetIdentity identity_of(drivers::Log const& log, std::vector<std::size_t> const& pens,
                                   std::string const& name)
{
    sim::UsbGadgetIdentity identity {
        .name = name,
        .vendor_id = kTestVendor,
        .product_id = pens.empty() ? kSensorProduct : kPenProduct,
        .manufacturer = "tractus",
        .product = pens.empty() ? "Height sensor" : log.devices[pens.front()].name,
        .serial_number = "0001",
    };
    if (!pens.empty() && log.devices[pens.front()].vendor_id != 0) {
        identity.vendor_id = log.devices[pens.front()].vendor_id;
        identity.product_id = log.devices[pens.front()].product_id;
    }
    return identity;
}

Result<void> add_pens(Functions& functions, sim::UsbGadget& gadget, drivers::Log const& log,
                      std::vector<std::size_t> const& pens, std::optional<double> rate_hz)
{
    for (auto const device : pens) {
        auto pen = TRY(
            sim::GadgetHid::add_to(gadget, fmt::format("pen{}", device), log.devices[device]));
        functions.pen_parts.push_back(
            std::make_unique<play::ReportPart>(*pen, reports_of(log, device, rate_hz)));
        functions.pens.push_back(std::move(pen));
    }
    return {};
}

Result<void> play_gadget(SimGadgetArguments const& arguments)
{
    auto const log = TRY(load_sim_play(arguments.play));
    auto const pens = arguments.what == "sensor" ? std::vector<std::size_t>() : pens_in(log);
    if (arguments.what != "sensor" && pens.empty())
        return fail(Fault::User, fmt::format("there is no pen to play in {}", log.name));
    auto const gadget = TRY(sim::UsbGadget::create(identity_of(log, pens, arguments.name)));
    Functions functions;
    TRY(add_pens(functions, *gadget, log, pens, arguments.rate_hz));
    if (arguments.what != "pen") {
        auto heights = TRY(sim::HeightCurve::read(log));
        functions.sensor = TRY(play::PlayedHeightSensor::add_to(*gadget, std::move(heights)));
    }
    TRY(gadget->plug_in(arguments.port));
    return run_sim_play(functions.play(), arguments.play);
}

} // namespace

void add_sim_gadget_command(CLI::App& sim, options::Action& action)
{
    auto* const command = sim.add_subcommand(
        "gadget", "As a USB device, on this computer's USB device port: a test rig one can hold");
    auto arguments = std::make_shared<SimGadgetArguments>();
    command->add_option("WHAT", arguments->what, "pen, sensor or both")
        ->required()
        ->check(CLI::IsMember({ "pen", "sensor", "both" }));
    add_sim_play_options(*command, arguments->play);
    command
        ->add_option("--rate", arguments->rate_hz,
                     "Send the pen's reports in even steps, so many per second, and not as they "
                     "were recorded; the host takes at most 1000")
        ->type_name("HZ")
        ->check(options::number(0.01, 1000));
    command
        ->add_option("--port", arguments->port,
                     "The port to plug in, as /sys/class/udc lists them; without it, the first "
                     "that is free")
        ->type_name("PORT");
    command
        ->add_option("--name", arguments->name,
                     "Of the device in the kernel's configfs; several need several names")
        ->type_name("NAME")
        ->capture_default_str();
    command->footer(
        "The host sees a pen tablet, the station's own height sensor, or one device that is\n"
        "both, as if they were plugged in. Reports are sent from when the host reads them all;\n"
        "until then the pen repeats its first one. Ctrl-C, or the end, unplugs the device and "
        "leaves nothing behind.\n"
        "\n"
        "On a Raspberry Pi with a USB device port (Zero, 4, 5): add the line\n"
        "\"dtoverlay=dwc2\" to config.txt, restart, and then\n"
        "  sudo modprobe -a dwc2 libcomposite\n"
        "  sudo tractus sim gadget both --simulate SCRIPT --repeat\n"
        "and plug its USB cable into the computer with the station.\n"
        "\n"
        "On a PC without such a port the kernel plays host and port at once:\n"
        "  sudo modprobe -a dummy_hcd libcomposite");
    command->callback(
        [arguments, &action] { action = [arguments] { return play_gadget(*arguments); }; });
}

} // namespace tractus::commands
