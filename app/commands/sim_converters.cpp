#include "app/commands/sim_converters.h"

#include "app/commands/sim_play.h"
#include "app/options/checks.h"
#include "drivers/reports/clock.h"
#include "sim/height_curve.h"
#include "sim/uhid_converters.h"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace tractus::commands {

namespace {

struct SimConvertersArguments {
    SimPlayArguments play;
    std::vector<unsigned> lines { 0, 1, 2, 3 };
    unsigned channel = 0;
    std::optional<double> fail_after_s;
};

struct SimEncoderArguments {
    SimPlayArguments play;
    std::vector<unsigned> lines { 0, 1 };
    unsigned counts = 40;
};

// Time for which a simulated encoder rests before and after its movement. During the first rest a
// reader starts counting; during the last one it reads the remaining edges before the encoder
// disappears.
constexpr Duration kEncoderRest = std::chrono::seconds(2);

// Plays a recording's heights on a simulated converter and finally triggers its fault, if one is
// set. Time starts with the first read request, as the kernel's own driver may open the converter
// without reading it. The height rests for `rest` at the start and at the end.
class HeightPart final : public play::DevicePart {
public:
    explicit HeightPart(sim::HeightCurve heights, Duration rest = Duration(0))
        : heights_(std::move(heights))
        , rest_(rest)
    {
    }

    void fail_after(double seconds, std::function<void()> fail)
    {
        fail_after_ = from_seconds(seconds);
        fail_ = std::move(fail);
    }

    double fraction_now()
    {
        auto const now = drivers::monotonic_now();
        begin_ = begin_.value_or(now);
        return heights_.fraction_at(Timestamp(now - *begin_ - rest_));
    }

    void begin(Timestamp) override { begin_.reset(); }

    Timestamp due() const override
    {
        return begin_ && fail_after_ ? *begin_ + *fail_after_ : Timestamp::max();
    }

    Result<void> play(Timestamp) override
    {
        fail_after_.reset();
        fail_();
        return {};
    }

    bool is_over(Timestamp now) const override
    {
        return begin_ && now - *begin_ - 2 * rest_ > heights_.end().time_since_epoch();
    }

private:
    sim::HeightCurve heights_;
    Duration rest_;
    std::optional<Timestamp> begin_ {};
    std::optional<Duration> fail_after_ {};
    std::function<void()> fail_ {};
};

Result<void> play_part(sim::KernelDevice& device, HeightPart& part,
                       SimPlayArguments const& arguments)
{
    play::PlaybackSet play;
    play.devices = { &device };
    play.parts = { &part };
    return run_sim_play(std::move(play), arguments);
}

Result<void> play_mcp2221a(SimPlayArguments const& arguments)
{
    auto const log = TRY(load_sim_play(arguments));
    HeightPart part(TRY(sim::HeightCurve::read(log)));
    auto const device = TRY(sim::play_mcp2221a([&part] { return part.fraction_now(); }));
    return play_part(*device, part, arguments);
}

Result<void> play_desk(SimPlayArguments const& arguments)
{
    auto const log = TRY(load_sim_play(arguments));
    HeightPart part(TRY(sim::HeightCurve::read(log)));
    bool has_move_command = false;
    auto const device = TRY(sim::play_linak_desk([&part] { return part.fraction_now(); },
                                                 [&] { has_move_command = true; }));
    TRY(play_part(*device, part, arguments));
    if (has_move_command)
        return fail(Fault::Device, "some program told the desk to move, which none of ours does");
    return {};
}

Result<void> play_encoder(SimEncoderArguments const& arguments)
{
    auto const log = TRY(load_sim_play(arguments.play));
    HeightPart part(TRY(sim::HeightCurve::read(log)), kEncoderRest);
    auto const target = [&] {
        return static_cast<std::int64_t>(std::floor(part.fraction_now() * arguments.counts));
    };
    sim::Cp2112WithEncoder bridge({ .a = arguments.lines[0], .b = arguments.lines[1] }, target);
    auto const device = TRY(bridge.play());
    return play_part(*device, part, arguments.play);
}

Result<void> play_iio(SimPlayArguments const& arguments)
{
    auto const log = TRY(load_sim_play(arguments));
    HeightPart part(TRY(sim::HeightCurve::read(log)));
    sim::Cp2112WithMcp3421 bridge([&part] { return part.fraction_now(); });
    auto const device = TRY(bridge.play());
    return play_part(*device, part, arguments);
}

Result<void> play_cp2112(SimConvertersArguments const& arguments)
{
    auto const log = TRY(load_sim_play(arguments.play));
    HeightPart part(TRY(sim::HeightCurve::read(log)));
    auto const input = [&](unsigned channel) {
        return channel == arguments.channel ? part.fraction_now() : (channel + 1) / 10.0;
    };
    auto const& lines = arguments.lines;
    sim::Cp2112WithMcp3208 bridge(
        { .clk = lines[0], .din = lines[1], .dout = lines[2], .cs = lines[3] }, input);
    if (arguments.fail_after_s)
        part.fail_after(*arguments.fail_after_s, [&bridge] { bridge.fail_readings(); });
    auto const device = TRY(bridge.play());
    return play_part(*device, part, arguments.play);
}

void add_mcp2221a_command(CLI::App& sim, options::Action& action)
{
    auto* const command = sim.add_subcommand(
        "mcp2221a", "A Microchip MCP2221A that measures a recording's heights, through /dev/uhid");
    auto arguments = std::make_shared<SimPlayArguments>();
    add_sim_play_options(*command, *arguments);
    command->footer(
        "Its inputs GP1, GP2 and GP3 all have the height's voltage. The heights move from\n"
        "when a program reads it. Needs root, or the right to use /dev/uhid.");
    command->callback(
        [arguments, &action] { action = [arguments] { return play_mcp2221a(*arguments); }; });
}

void add_desk_command(CLI::App& sim, options::Action& action)
{
    auto* const command = sim.add_subcommand(
        "desk", "A LINAK standing desk that moves as a recording's surface, through /dev/uhid");
    auto arguments = std::make_shared<SimPlayArguments>();
    add_sim_play_options(*command, *arguments);
    command->footer(
        "It answers as the cable USB2LIN06 does, and has to be initialised as that one. It moves\n"
        "from when a program reads it. Needs root, or the right to use /dev/uhid.");
    command->callback(
        [arguments, &action] { action = [arguments] { return play_desk(*arguments); }; });
}

void add_iio_command(CLI::App& sim, options::Action& action)
{
    auto* const command = sim.add_subcommand(
        "iio", "An MCP3421 on the I2C bus of a CP2112, for the kernel's industrial I/O");
    auto arguments = std::make_shared<SimPlayArguments>();
    add_sim_play_options(*command, *arguments);
    command->footer(
        "The kernel's driver hid-cp2112 makes a bus of it, and has to be told of the chip:\n"
        "  modprobe mcp3422\n"
        "  echo mcp3421 0x68 > /sys/bus/i2c/devices/i2c-N/new_device\n"
        "where the name of i2c-N begins with CP2112. Then the station's address is\n"
        "iio:device0:voltage0@max=2047, or as \"tractus devices\" lists it. Needs root, or the\n"
        "right to use /dev/uhid.");
    command->callback(
        [arguments, &action] { action = [arguments] { return play_iio(*arguments); }; });
}

void add_cp2112_command(CLI::App& sim, options::Action& action)
{
    auto* const command = sim.add_subcommand(
        "cp2112", "An MCP3208 on the GPIO lines of a CP2112 that measures a recording's heights");
    auto arguments = std::make_shared<SimConvertersArguments>();
    add_sim_play_options(*command, arguments->play);
    command
        ->add_option("--lines", arguments->lines,
                     "The lines that CLK, DIN, DOUT and CS of the MCP3208 are wired to")
        ->type_name("CLK DIN DOUT CS")
        ->expected(4)
        ->check(options::whole_number(0, 7))
        ->capture_default_str();
    command
        ->add_option("--channel", arguments->channel,
                     "The channel that has the height; each other one, C, has (C + 1) / 10 of "
                     "full scale")
        ->type_name("C")
        ->check(options::whole_number(0, 7))
        ->capture_default_str();
    command
        ->add_option("--fail-after", arguments->fail_after_s,
                     "From then on the lines cannot be read, as if the cable were bad")
        ->type_name("SECONDS")
        ->check(options::number(0, 1e6));
    command->footer(
        "The kernel's driver hid-cp2112 makes a gpiochip of it, labelled cp2112_gpio. Then the\n"
        "station's address of channel 0 is gpio:cp2112_gpio:0,1,2,3:mcp3208:0. Needs root, or the\n"
        "right to use /dev/uhid.");
    command->callback(
        [arguments, &action] { action = [arguments] { return play_cp2112(*arguments); }; });
}

void add_encoder_command(CLI::App& sim, options::Action& action)
{
    auto* const command = sim.add_subcommand(
        "encoder",
        "A draw-wire encoder on the GPIO lines of a CP2112 that moves as a recording's "
        "surface");
    auto arguments = std::make_shared<SimEncoderArguments>();
    add_sim_play_options(*command, arguments->play);
    command->add_option("--lines", arguments->lines, "The lines that A and B are wired to")
        ->type_name("A B")
        ->expected(2)
        ->check(options::whole_number(0, 7))
        ->capture_default_str();
    command
        ->add_option("--counts", arguments->counts,
                     "How far it counts over the full scale of the recording's sensor")
        ->type_name("N")
        ->check(options::whole_number(1, 1000000))
        ->capture_default_str();
    command->footer(
        "The kernel's driver hid-cp2112 makes a gpiochip of it, whose lines it looks at 25 times\n"
        "a second: the encoder counts no quicker, and rests for two seconds before it moves, and\n"
        "after. The station's address is gpio:cp2112_gpio:0,1:quadrature. Needs root, or the\n"
        "right to use /dev/uhid.");
    command->callback(
        [arguments, &action] { action = [arguments] { return play_encoder(*arguments); }; });
}

} // namespace

void add_sim_converter_commands(CLI::App& sim, options::Action& action)
{
    add_mcp2221a_command(sim, action);
    add_desk_command(sim, action);
    add_iio_command(sim, action);
    add_cp2112_command(sim, action);
    add_encoder_command(sim, action);
}

} // namespace tractus::commands
