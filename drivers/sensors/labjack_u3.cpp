#include "drivers/sensors/labjack_u3.h"

#include "drivers/reports/report_bytes.h"
#include "drivers/sensors/labjack_packet.h"
#include "drivers/sensors/polled_source.h"
#include "drivers/sensors/sensor_volts.h"
#include "drivers/sensors/settings.h"
#include "drivers/usb/usb_link.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <string>
#include <utility>

namespace tractus::drivers {

namespace {

constexpr std::uint16_t kLabjackVendorId = 0x0CD5;
constexpr std::uint16_t kLabjackProductId = 0x0003;
constexpr std::uint8_t kCommandEndpoint = 0x01;
constexpr std::uint8_t kAnswerEndpoint = 0x82;

// Time between two requests. The firmware can answer far faster.
constexpr Duration kLabjackPeriod = std::chrono::milliseconds(4);
constexpr int kLabjackAttempts = 5;
constexpr std::int32_t kLabjackFullScale = 0xFFF0;

constexpr std::byte kAnalogInput { 1 }; // IOType of an analogue input.
constexpr std::byte kAgainstGround { 31 };
constexpr std::size_t kFeedbackBytes = 12;

using Bytes = std::span<std::byte const>;

// Reads a signed fixed-point number with 32 bits before the point and 32 after it.
double fixed_point(Bytes bytes, std::size_t at)
{
    return static_cast<std::int32_t>(u32(bytes, at + 4)) + u32(bytes, at) / 4294967296.0;
}

// Returns a test for the reply to a command. It rejects the U3's "bad checksum" packet, which the
// U3 sends if our command was corrupted.
PacketTest answers(LabJackCommand command)
{
    return [command](Bytes packet) {
        return check_labjack_packet(packet) == LabJackDefect::None
            && packet[3] == static_cast<std::byte>(command);
    };
}

struct Question {
    LabJackCommand command {};
    std::vector<std::byte> data {};
    std::size_t answer_bytes = 0; // Data size of the reply in bytes.
};

// Sends a command and returns the data of the reply, which begins with the error code.
Result<std::vector<std::byte>> ask(PacketLink& link, Question const& question,
                                   std::string const& who)
{
    auto const number = static_cast<unsigned>(question.command);
    auto const packet = labjack_packet(question.command, question.data);
    auto const answer = TRY(exchange(link, packet, answers(question.command), kLabjackAttempts));
    if (!answer || answer->size < kLabJackHeaderBytes + question.answer_bytes)
        return fail(Fault::Device,
                    fmt::format("{} does not answer command {:02x} as a U3 does (is another "
                                "program using it?)",
                                who, number));
    auto const data = answer->bytes().subspan(kLabJackHeaderBytes);
    if (data[0] != std::byte {})
        return fail(Fault::Device,
                    fmt::format("{} answers command {:02x} with error {}", who, number,
                                std::to_integer<unsigned>(data[0])));
    return std::vector<std::byte>(data.begin(), data.end());
}

struct Identity {
    std::uint32_t serial_number = 0;
    bool is_high_voltage = false;
};

Result<Identity> read_identity(PacketLink& link, std::string const& who)
{
    constexpr unsigned kHighVoltage = 18; // Both bits set: a U3C with the front end of the HV.
    auto const told
        = TRY(ask(link, { LabJackCommand::ConfigU3, std::vector<std::byte>(20), 32 }, who));
    return Identity { .serial_number = u32(told, 9),
                      .is_high_voltage
                      = (std::to_integer<unsigned>(told[31]) & kHighVoltage) == kHighVoltage };
}

struct Calibration {
    double volts_per_count = 0; // Volts per count of a 16-bit reading.
    double offset_volts = 0;
};

// Reads a block of 32 bytes from the U3's memory. In the reply it follows the error code and a
// spare byte.
Result<std::vector<std::byte>> read_block(PacketLink& link, unsigned block, std::string const& who)
{
    auto data = TRY(ask(
        link, { LabJackCommand::ReadMemory, { std::byte {}, static_cast<std::byte>(block) }, 34 },
        who));
    data.erase(data.begin(), data.begin() + 2);
    return data;
}

// Reads the calibration (U3 user's guide, section 5.4). Block 0 has slope and offset of the
// single-ended low-voltage inputs; blocks 3 and 4 have the slopes and the offsets of the four
// high-voltage inputs.
Result<Calibration> read_calibration(PacketLink& link, bool is_high_voltage, int channel,
                                     std::string const& who)
{
    if (!is_high_voltage || channel >= 4) {
        auto const block = TRY(read_block(link, 0, who));
        return Calibration { fixed_point(block, 0), fixed_point(block, 8) };
    }
    auto const at = 8 * static_cast<std::size_t>(channel);
    auto const slopes = TRY(read_block(link, 3, who));
    auto const offsets = TRY(read_block(link, 4, who));
    return Calibration { fixed_point(slopes, at), fixed_point(offsets, at) };
}

// Makes the channel an analogue input. All pins are digital when the U3 starts, so both bytes of
// analogue pins are read first, and written with one more bit set.
Result<void> set_up(PacketLink& link, int channel, std::string const& who)
{
    constexpr std::byte kWriteAnalog { 0x0C }; // Write masks for the analogue pins of FIO and EIO.
    Question question { LabJackCommand::ConfigIo, std::vector<std::byte>(6), 6 };
    auto const present = TRY(ask(link, question, who));
    question.data = { kWriteAnalog, {}, present[2], present[3], present[4], present[5] };
    auto& pins = question.data[channel < 8 ? 4 : 5];
    pins |= static_cast<std::byte>(1 << channel % 8);
    TRY(ask(link, question, who));
    return {};
}

Result<void> check_answer(Bytes report)
{
    auto const defect = check_labjack_packet(report);
    if (defect == LabJackDefect::TooShort || report.size() < kFeedbackBytes)
        return fail(
            Fault::Device,
            fmt::format("LabJack answer: {} bytes, expected {}", report.size(), kFeedbackBytes));
    if (defect != LabJackDefect::None)
        return fail(Fault::Device, "LabJack answer: its checksum is wrong");
    if (report[6] != std::byte {})
        return fail(Fault::Device,
                    fmt::format("LabJack answer: error {}, expected 0",
                                std::to_integer<unsigned>(report[6])));
    return {};
}

class LabJackU3Decoder final : public HeightDecoder {
public:
    std::int32_t full_scale() const override { return kLabjackFullScale; }

    using HeightDecoder::decode;
    Result<void> decode(Timestamp received, Bytes report, std::vector<HeightSample>& out) override
    {
        TRY(check_answer(report));
        if (report[3] != static_cast<std::byte>(LabJackCommand::Feedback))
            return {};
        auto const counts = std::min<std::int32_t>(u16(report, 9), kLabjackFullScale);
        out.push_back({ .time = received, .counts = counts, .full_scale = kLabjackFullScale });
        return {};
    }
};

} // namespace

bool is_labjack_u3(DeviceInfo const& info)
{
    return info.vendor_id == kLabjackVendorId && info.product_id == kLabjackProductId;
}

Result<LabJackU3Options> parse_labjack_u3_options(std::string_view settings)
{
    LabJackU3Options options;
    for (auto const word : split_settings(settings)) {
        auto const channel = number_between("AIN", word, "");
        if (!channel || *channel > 15)
            return fail(Fault::User,
                        fmt::format("'{}' is no setting of the U3: expected AIN0 to "
                                    "AIN15",
                                    word));
        options.channel = *channel;
    }
    return options;
}

Result<std::unique_ptr<ReportSource>> open_labjack_u3(DeviceInfo info)
{
    auto const options = TRY(parse_labjack_u3_options(info.settings));
    auto link = TRY(open_usb_link(info,
                                  { .interface_number = 0,
                                    .out_endpoint = kCommandEndpoint,
                                    .in_endpoint = kAnswerEndpoint }));
    return open_labjack_u3(std::move(info), std::move(link), options);
}

Result<std::unique_ptr<ReportSource>>
open_labjack_u3(DeviceInfo info, std::unique_ptr<PacketLink> link, LabJackU3Options const& options)
{
    if (options.channel < 0 || options.channel > 15)
        return fail(Fault::User,
                    fmt::format("the U3 has no AIN{}: use AIN0 to AIN15", options.channel));
    auto const who = fmt::format("{} at {}", info.name, info.location);
    auto const identity = TRY(read_identity(*link, who));
    auto const calibration
        = TRY(read_calibration(*link, identity.is_high_voltage, options.channel, who));
    // The serial number of the U3 goes into the name. The serial number in `info` stays USB's, by
    // which the device is found again.
    info.name
        = fmt::format("LabJack U3-{} {}, AIN{}, {}", identity.is_high_voltage ? "HV" : "LV",
                      identity.serial_number, options.channel,
                      print_volts_per_count(calibration.volts_per_count, calibration.offset_volts));
    std::array const feedback { std::byte {}, kAnalogInput, static_cast<std::byte>(options.channel),
                                kAgainstGround };
    return open_polled(
        std::move(info), std::move(link),
        { .command = labjack_packet(LabJackCommand::Feedback, feedback),
          .is_reply = answers(LabJackCommand::Feedback),
          .period = kLabjackPeriod,
          .set_up = [=](PacketLink& to) { return set_up(to, options.channel, who); } });
}

Result<std::unique_ptr<HeightDecoder>> make_labjack_u3_decoder(DeviceInfo const&)
{
    return std::make_unique<LabJackU3Decoder>();
}

} // namespace tractus::drivers
