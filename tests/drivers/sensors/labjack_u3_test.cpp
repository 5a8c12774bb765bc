#include "drivers/sensors/labjack_u3.h"

#include "drivers/height_decoders.h"
#include "drivers/sensors/labjack_packet.h"
#include "sim/labjack_u3_model.h"
#include "tests/drivers/bytes.h"
#include "tests/drivers/heights.h"
#include "tests/drivers/sensors/fake_link.h"

#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

using namespace std::chrono_literals;
using Bytes = FakeWire::Bytes;

DeviceInfo u3()
{
    return {
        .name = "LabJack U3", .location = "usb:1-2", .vendor_id = 0x0CD5, .product_id = 0x0003
    };
}

struct LabJackU3 : testing::Test {
    LabJackU3()
    {
        wire.answer = [this](std::span<std::byte const> command) { return model.answer(command); };
    }

    Result<std::unique_ptr<ReportSource>> open(LabJackU3Options const& options = {})
    {
        return open_labjack_u3(u3(), std::make_unique<FakeLink>(wire), options);
    }

    static int read(ReportSource& source)
    {
        auto const report = source.read(100ms).value();
        if (!report)
            return -1;
        auto const decoder = make_height_decoder(source.info()).value();
        return decode_heights(*decoder, *report).value().at(0).counts;
    }

    sim::LabJackU3Model model;
    FakeWire wire;
};

// The expected packet is that of the user's guide for reading one single-ended analogue input.
TEST(LabJackPacket, HasBothChecksums)
{
    auto const packet = labjack_packet(LabJackCommand::Feedback, bytes("00 01 00 1f"));
    EXPECT_EQ(packet, bytes("1b f8 02 00 20 00 00 01 00 1f"));
    EXPECT_EQ(check_labjack_packet(packet), LabJackDefect::None);
}

TEST(LabJackPacket, AddsTheCarryBackIntoTheFirstChecksum)
{
    auto const packet = labjack_packet(LabJackCommand::ReadMemory, bytes("ff ff"));
    EXPECT_EQ(packet, bytes("27 f8 01 2d fe 01 ff ff"));
}

TEST(LabJackPacket, TellsWhatIsWrong)
{
    auto packet = labjack_packet(LabJackCommand::ConfigIo, bytes("00 00 00 00 01 00"));
    packet.back() ^= std::byte { 4 };
    EXPECT_EQ(check_labjack_packet(packet), LabJackDefect::DataChecksum);
    packet[3] = std::byte { 0x0C };
    EXPECT_EQ(check_labjack_packet(packet), LabJackDefect::HeaderChecksum);
    packet[1] = std::byte { 0xB8 };
    EXPECT_EQ(check_labjack_packet(packet), LabJackDefect::NotExtended);
    EXPECT_EQ(check_labjack_packet(bytes("b8 b8")), LabJackDefect::TooShort);
    auto const cut = labjack_packet(LabJackCommand::ConfigIo, bytes("00 00 00 00 01 00"));
    EXPECT_EQ(check_labjack_packet(std::span(cut).first(9)), LabJackDefect::TooShort);
}

TEST_F(LabJackU3, ReadsItsFirstInput)
{
    model.set_counts(0, 0x8120);
    auto const source = open();
    ASSERT_TRUE(source) << source.error().message;
    EXPECT_EQ(read(**source), 0x8120);
}

TEST_F(LabJackU3, TellsWhoItIsAndItsCalibration)
{
    auto const source = open().value();
    EXPECT_EQ(source->info().name,
              "LabJack U3-LV 320012345, AIN0, 3.7231e-05 V per count from 0 V");
}

TEST_F(LabJackU3, ReadsTheHighVoltageInputsCalibration)
{
    model = sim::LabJackU3Model({ .is_high_voltage = true });
    EXPECT_EQ(open({ .channel = 2 }).value()->info().name,
              "LabJack U3-HV 320012345, AIN2, 0.000314 V per count from -10.3 V");
    EXPECT_EQ(open({ .channel = 4 }).value()->info().name,
              "LabJack U3-HV 320012345, AIN4, 3.7231e-05 V per count from 0 V");
}

TEST_F(LabJackU3, MakesOnePinAnalogAndKeepsTheOthers)
{
    // Another program has made AIN1 and AIN9 analogue.
    auto const others = labjack_packet(LabJackCommand::ConfigIo, bytes("0c 00 00 00 02 02"));
    model.answer(others);
    for (int const channel : { 1, 9, 10 })
        model.set_counts(channel, static_cast<std::uint16_t>(channel * 0x100));
    EXPECT_EQ(read(*open({ .channel = 10 }).value()), 0xA00);
    auto const told
        = model.answer(labjack_packet(LabJackCommand::ConfigIo, bytes("00 00 00 00 00 00")));
    EXPECT_EQ(told[10], std::byte { 0x02 });
    EXPECT_EQ(told[11], std::byte { 0x06 });
}

TEST_F(LabJackU3, ReadsTwoHundredAndFiftyTimesASecond)
{
    auto const source = open().value();
    auto const start = wire.now;
    int reports = 0;
    while (wire.now < start + 1s)
        reports += source->read(10ms).value().has_value();
    EXPECT_NEAR(reports, 250, 1);
}

TEST_F(LabJackU3, AsksAgainWhenAnAnswerIsLostCutOffOrCorrupt)
{
    model.set_counts(0, 0x4000);
    auto const source = open().value();
    int answers = 0;
    wire.disturb = [&](Bytes answer) {
        switch (++answers % 4) {
        case 0:
            return std::vector<Bytes>();
        case 1:
            answer.resize(7);
            break;
        case 2:
            answer[9] ^= std::byte { 0x80 };
            break;
        default:
            break;
        }
        return std::vector<Bytes> { std::move(answer) };
    };
    int good = 0;
    for (int i = 0; i < 40; ++i) {
        auto const counts = read(*source);
        EXPECT_TRUE(counts == 0x4000 || counts == -1) << counts;
        good += counts == 0x4000;
    }
    EXPECT_GT(good, 15);
}

TEST_F(LabJackU3, OpensThoughACommandIsCorruptedOnItsWay)
{
    int commands = 0;
    wire.answer = [&](std::span<std::byte const> command) {
        return ++commands % 2 ? bytes("b8 b8") : model.answer(command);
    };
    EXPECT_TRUE(open());
}

TEST_F(LabJackU3, GivesASilentOneUpAfterASecond)
{
    auto const source = open().value();
    wire.disturb = [](Bytes const&) { return std::vector<Bytes>(); };
    auto const start = wire.now;
    Result<std::optional<RawReport>> report;
    while ((report = source->read(20ms)) && wire.now < start + 10s)
        EXPECT_FALSE(*report);
    ASSERT_FALSE(report);
    EXPECT_LT(wire.now, start + 1200ms);
}

TEST_F(LabJackU3, SaysThatItWasUnplugged)
{
    auto const source = open().value();
    wire.is_plugged = false;
    EXPECT_FALSE(source->read(10ms));
}

TEST_F(LabJackU3, BlamesTheUserForAChannelThatIsNotThere)
{
    auto const source = open({ .channel = 16 });
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().fault, Fault::User);
}

TEST(LabJackU3Options, AreReadFromAnAddress)
{
    EXPECT_EQ(parse_labjack_u3_options("").value().channel, 0);
    EXPECT_EQ(parse_labjack_u3_options("AIN15").value().channel, 15);
    for (auto const* const wrong : { "AIN16", "AIN", "AIN-1", "FIO0", "AIN1x" })
        EXPECT_FALSE(parse_labjack_u3_options(wrong)) << wrong;
}

TEST_F(LabJackU3, DecoderTellsAnErrorOfTheDevice)
{
    // The requested pin is still digital.
    auto const answer
        = model.answer(labjack_packet(LabJackCommand::Feedback, bytes("00 01 05 1f")));
    auto const decoder = make_height_decoder(u3()).value();
    auto const height = decode_heights(*decoder, {}, answer);
    ASSERT_FALSE(height);
    EXPECT_EQ(height.error().message, "LabJack answer: error 98, expected 0");
}

TEST_F(LabJackU3, DecoderRefusesWhatAChecksumRefutes)
{
    model = sim::LabJackU3Model({ .is_high_voltage = true });
    auto answer = model.answer(labjack_packet(LabJackCommand::Feedback, bytes("00 01 00 1f")));
    answer[10] ^= std::byte { 1 };
    auto const decoder = make_height_decoder(u3()).value();
    auto const height = decode_heights(*decoder, {}, answer);
    ASSERT_FALSE(height);
    EXPECT_EQ(height.error().message, "LabJack answer: its checksum is wrong");
    EXPECT_FALSE(decode_heights(*decoder, {}, bytes("b8 b8")));
}

} // namespace
} // namespace tractus::drivers
