#include "drivers/sensors/mcp2221a.h"

#include "drivers/links/hid_link.h"
#include "drivers/sensors/polled_source.h"
#include "drivers/sensors/sensor_volts.h"
#include "drivers/sensors/settings.h"
#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <string_view>
#include <utility>

namespace tractus::drivers {

namespace {

constexpr std::uint16_t kMicrochipVendorId = 0x04D8;
constexpr std::uint16_t kMicrochipProductId = 0x00DD;
constexpr std::size_t kPacketBytes = 64;
using Packet = std::array<std::byte, kPacketBytes>;

// Commands (MCP2221A datasheet, section 3.1): the packet's first byte, which the reply repeats.
constexpr std::byte kStatus { 0x10 };
constexpr std::byte kSetSettings { 0x60 };
constexpr std::byte kGetSettings { 0x61 };
constexpr std::byte kDone { 0x00 };

constexpr std::byte kChange { 0x80 };
// Pin function of GP1 to GP3: input of the converter.
constexpr std::byte kConverterFunction { 0x02 };
// Offset of the reference in the command that changes the settings.
constexpr std::size_t kReferenceAt = 5;
constexpr std::size_t kChangePinsAt = 7;
constexpr std::size_t kSetPinsAt = 8;
// Offset of the pin settings in the reply with the settings.
constexpr std::size_t kConfiguredPinsAt = 22;
constexpr std::size_t kPins = 4;
// Offset of the readings in the status reply: GP1, GP2, GP3.
constexpr std::size_t kReadingsAt = 50;

// Polling interval. The fastest host controllers transfer 500 commands and replies a second.
constexpr Duration kMcp2221aPeriod = std::chrono::milliseconds(2);
constexpr int kMcp2221aAttempts = 5;
constexpr std::int32_t kMcp2221aFullScale = 1023;
constexpr std::string_view kPinMark = ", GP";

// Returns the bits of a reference. Bit 0 is set for an internal voltage and clear for the supply;
// bits 2 and 1 select the internal voltage.
std::byte reference_bits(Mcp2221aReference reference)
{
    auto const index = static_cast<unsigned>(reference);
    return index == 0 ? std::byte {} : static_cast<std::byte>(index << 1 | 1);
}

// Returns the reference voltage; 0 for the supply, whose voltage is not known.
double volts(Mcp2221aReference reference)
{
    constexpr std::array kVolts { 0.0, 1.024, 2.048, 4.096 };
    return kVolts[static_cast<std::size_t>(reference)];
}

PacketTest answers(std::byte command)
{
    return [command](std::span<std::byte const> packet) {
        return packet.size() == kPacketBytes && packet[0] == command;
    };
}

Result<RawReport> ask(PacketLink& link, Packet const& command, std::string const& who)
{
    auto const answer = TRY(exchange(link, command, answers(command[0]), kMcp2221aAttempts));
    auto const number = std::to_integer<unsigned>(command[0]);
    if (!answer)
        return fail(
            Fault::Device,
            fmt::format("{} does not answer command {:02x} (is it an MCP2221A?)", who, number));
    if (answer->storage[1] != kDone)
        return fail(Fault::Device,
                    fmt::format("{} refuses command {:02x} with code {:02x}", who, number,
                                std::to_integer<unsigned>(answer->storage[1])));
    return *answer;
}

// Configures the pin and the reference. Setting the pins resets the reference to the supply, so one
// command sets both (MCP2221A datasheet, section 1.8.1.1). It also sets the other pins, to their
// present state.
Result<void> set_up(PacketLink& link, Mcp2221aOptions const& options, std::string const& who)
{
    auto const settings = TRY(ask(link, Packet { kGetSettings }, who));
    Packet command { kSetSettings };
    command[kReferenceAt] = kChange | reference_bits(options.reference);
    command[kChangePinsAt] = kChange;
    std::copy_n(settings.storage.begin() + kConfiguredPinsAt, kPins, command.begin() + kSetPinsAt);
    command[kSetPinsAt + static_cast<std::size_t>(options.pin)] = kConverterFunction;
    TRY(ask(link, command, who));
    return {};
}

class Mcp2221aDecoder final : public HeightDecoder {
public:
    explicit Mcp2221aDecoder(std::size_t pin)
        : pin_(pin)
    {
    }

    std::int32_t full_scale() const override { return kMcp2221aFullScale; }

    using HeightDecoder::decode;
    Result<void> decode(Timestamp received, std::span<std::byte const> report,
                        std::vector<HeightSample>& out) override;

private:
    std::size_t pin_;
};

Result<void> Mcp2221aDecoder::decode(Timestamp received, std::span<std::byte const> report,
                                     std::vector<HeightSample>& out)
{
    if (report.empty() || report[0] != kStatus)
        return {};
    if (report.size() < kPacketBytes)
        return fail(
            Fault::Device,
            fmt::format("MCP2221A status: {} bytes, expected {}", report.size(), kPacketBytes));
    auto const at = kReadingsAt + 2 * (pin_ - 1);
    auto const counts = std::to_integer<std::int32_t>(report[at])
        | std::to_integer<std::int32_t>(report[at + 1]) << 8;
    if (report[1] != kDone || counts > kMcp2221aFullScale)
        return fail(Fault::Device,
                    fmt::format("MCP2221A status: code {:02x} and {} counts on GP{}, expected 00 "
                                "and at most {}",
                                std::to_integer<unsigned>(report[1]), counts, pin_,
                                kMcp2221aFullScale));
    out.push_back({ .time = received, .counts = counts, .full_scale = kMcp2221aFullScale });
    return {};
}

} // namespace

bool is_mcp2221a(DeviceInfo const& info)
{
    return info.vendor_id == kMicrochipVendorId && info.product_id == kMicrochipProductId;
}

Result<Mcp2221aOptions> parse_mcp2221a_options(std::string_view settings)
{
    constexpr std::array<std::string_view, 4> kReferences { "VDD", "1.024V", "2.048V", "4.096V" };
    Mcp2221aOptions options;
    for (auto const word : split_settings(settings)) {
        auto const reference = std::find(kReferences.begin(), kReferences.end(), word);
        if (word == "GP1" || word == "GP2" || word == "GP3")
            options.pin = word[2] - '0';
        else if (reference != kReferences.end())
            options.reference = static_cast<Mcp2221aReference>(reference - kReferences.begin());
        else
            return fail(Fault::User,
                        fmt::format("'{}' is no setting of the MCP2221A: expected "
                                    "GP1 to GP3, VDD, 1.024V, 2.048V or 4.096V",
                                    word));
    }
    return options;
}

Result<std::unique_ptr<ReportSource>> open_mcp2221a(DeviceInfo info)
{
    auto const options = TRY(parse_mcp2221a_options(info.settings));
    auto link = TRY(open_hid_link(info));
    return open_mcp2221a(std::move(info), std::move(link), options);
}

Result<std::unique_ptr<ReportSource>>
open_mcp2221a(DeviceInfo info, std::unique_ptr<PacketLink> link, Mcp2221aOptions const& options)
{
    if (options.pin < 1 || options.pin > 3)
        return fail(
            Fault::User,
            fmt::format("GP{} of the MCP2221A has no converter: use GP1, GP2 or GP3", options.pin));
    auto const who = fmt::format("{} at {}", info.name, info.location);
    info.name += fmt::format("{}{}", kPinMark, options.pin);
    if (auto const full = volts(options.reference); full > 0)
        info.name += ", " + print_volts_per_count(full / (kMcp2221aFullScale + 1), 0);
    Packet const status { kStatus };
    return open_polled(std::move(info), std::move(link),
                       { .command = { status.begin(), status.end() },
                         .is_reply = answers(kStatus),
                         .period = kMcp2221aPeriod,
                         .set_up = [=](PacketLink& to) { return set_up(to, options, who); },
                         .spoils = answers(kSetSettings) });
}

Result<std::unique_ptr<HeightDecoder>> make_mcp2221a_decoder(DeviceInfo const& info)
{
    std::size_t pin = 1;
    if (auto const at = info.name.rfind(kPinMark); at != std::string::npos) {
        auto const digit = info.name.substr(at + kPinMark.size());
        if (digit.starts_with('2') || digit.starts_with('3'))
            pin = static_cast<std::size_t>(digit[0] - '0');
    }
    return std::make_unique<Mcp2221aDecoder>(pin);
}

} // namespace tractus::drivers
