#include "sim/uhid_converters.h"

#include "drivers/sensors/linak_desk.h"
#include "engine/base/time.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::sim {

namespace {

constexpr double kSupply_volts = 5;

// Returns a descriptor with one input and one output report of 64 bytes, without ids, on a
// vendor-defined page.
std::vector<std::byte> mcp2221a_report_descriptor()
{
    std::vector<std::byte> descriptor;
    for (int const item :
         { 0x06, 0x00, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x15, 0x00, 0x26, 0xff, 0x00, 0x75,
           0x08, 0x95, 0x40, 0x09, 0x02, 0x81, 0x02, 0x09, 0x03, 0x91, 0x02, 0xc0 })
        descriptor.push_back(static_cast<std::byte>(item));
    return descriptor;
}

drivers::DeviceInfo mcp2221a_info()
{
    return {
        .name = "Microchip Technology Inc. MCP2221 USB-I2C/UART Combo",
        .location = "simulated",
        .physical_path = "simulated/mcp2221a",
        .vendor_id = 0x04d8,
        .product_id = 0x00dd,
        .report_descriptor = mcp2221a_report_descriptor(),
    };
}

std::vector<std::byte> answer(Mcp2221aModel& model, InputNow const& input,
                              std::span<std::byte const> command)
{
    // Programs put a 0 in front of the packet, as report id.
    if (command.size() > Mcp2221aModel::kPacketBytes)
        command = command.subspan(1);
    if (model.converts())
        for (int pin = 1; pin <= 3; ++pin)
            model.set_volts(pin, input() * kSupply_volts);
    auto const packet = model.answer(command);
    return { packet.begin(), packet.end() };
}

bool bit(unsigned levels, unsigned line)
{
    return levels >> line & 1;
}

// Emulates a CP2112, with or without a chip on its bus. The models must outlive the device.
Result<std::unique_ptr<UhidDevice>> play_bridge(Cp2112Model& bridge, Cp2112Bus* bus = nullptr)
{
    UhidAnswers answers;
    if (bus)
        answers.output = [bus](std::span<std::byte const> report) { return bus->output(report); };
    answers.get_feature = [&bridge](std::uint8_t id) { return bridge.get_feature(id); };
    answers.set_feature
        = [&bridge](std::span<std::byte const> report) { return bridge.set_feature(report); };
    return UhidDevice::create(Cp2112Model::info(), std::move(answers));
}

} // namespace

Result<std::unique_ptr<UhidDevice>> play_mcp2221a(InputNow input)
{
    Mcp2221aModel::Options options;
    options.supply_volts = kSupply_volts;
    UhidAnswers answers;
    answers.output
        = [model = Mcp2221aModel(options), input = std::move(input)](
              std::span<std::byte const> command) mutable { return answer(model, input, command); };
    return UhidDevice::create(mcp2221a_info(), std::move(answers));
}

Result<std::unique_ptr<UhidDevice>> play_linak_desk(InputNow input,
                                                    std::function<void()> on_move_command)
{
    // get_feature and set_feature share the model.
    auto const desk = std::make_shared<LinakDeskModel>();
    UhidAnswers answers;
    answers.get_feature = [desk, input = std::move(input)](std::uint8_t id) {
        auto const tenths_mm
            = std::lround(input() * drivers::kLinakFullScale) - drivers::kLinakCountsBelow;
        desk->move_to(static_cast<std::int16_t>(std::max(tenths_mm, 0L)));
        return desk->get_feature(id);
    };
    answers.set_feature
        = [desk, told = std::move(on_move_command)](std::span<std::byte const> report) {
              auto const before = desk->movement_count();
              bool const is_known = desk->set_feature(report);
              if (desk->movement_count() > before)
                  told();
              return is_known;
          };
    return UhidDevice::create({ .name = "LINAK USB Control Link",
                                .location = "simulated",
                                .physical_path = "simulated/desk",
                                .vendor_id = 0x12d3,
                                .product_id = 0x0002,
                                .report_descriptor = LinakDeskModel::report_descriptor() },
                              std::move(answers));
}

// Droop is disabled. Through this bridge a conversion takes milliseconds, in which the real
// converter's capacitor would lose a few counts, but only the lines are tested with this device.
// Without droop the converter does not depend on time.
Cp2112WithMcp3208::Cp2112WithMcp3208(Wiring const& wiring,
                                     std::function<double(unsigned channel)> input)
    : wiring_(wiring)
    , converter_([input = std::move(input)](unsigned channel, Timestamp) { return input(channel); },
                 { .bits = 12, .droop_per_second = 0 })
    , bridge_({ .driven = [this](std::uint8_t levels) { drive(levels); },
                .levels = [this] { return levels(); } })
{
}

Result<std::unique_ptr<UhidDevice>> Cp2112WithMcp3208::play()
{
    return play_bridge(bridge_);
}

void Cp2112WithMcp3208::drive(std::uint8_t levels)
{
    converter_.set_pins(Timestamp(),
                        { .clk = bit(levels, wiring_.clk),
                          .din = bit(levels, wiring_.din),
                          .cs = bit(levels, wiring_.cs) });
}

std::uint8_t Cp2112WithMcp3208::levels() const
{
    return static_cast<std::uint8_t>(converter_.dout().value_or(false) << wiring_.dout);
}

Cp2112WithMcp3421::Cp2112WithMcp3421(InputNow input)
    : converter_(std::move(input))
    , bridge_({})
    , bus_({ .address = Mcp3421Model::kAddress,
             .write = [this](std::span<std::byte const> bytes) { converter_.write(bytes); },
             .read = [this](std::size_t size) { return converter_.read(size); } })
{
}

Result<std::unique_ptr<UhidDevice>> Cp2112WithMcp3421::play()
{
    return play_bridge(bridge_, &bus_);
}

Cp2112WithEncoder::Cp2112WithEncoder(Wiring const& wiring, std::function<std::int64_t()> target)
    : wiring_(wiring)
    , target_(std::move(target))
    , bridge_({ .levels = [this] { return next_levels(); } })
{
}

Result<std::unique_ptr<UhidDevice>> Cp2112WithEncoder::play()
{
    return play_bridge(bridge_);
}

std::uint8_t Cp2112WithEncoder::next_levels()
{
    auto const target = target_();
    if (count_)
        *count_ += std::clamp<std::int64_t>(target - *count_, -1, 1);
    else
        count_ = begin_ = target;
    auto const level = [&](drivers::QuadratureEdge::Line line, unsigned at) {
        return static_cast<unsigned>(is_encoder_line_high(line, *count_ - begin_)) << at;
    };
    return static_cast<std::uint8_t>(level(drivers::QuadratureEdge::Line::A, wiring_.a)
                                     | level(drivers::QuadratureEdge::Line::B, wiring_.b));
}

} // namespace tractus::sim
