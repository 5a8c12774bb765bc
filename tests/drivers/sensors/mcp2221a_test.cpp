#include "drivers/sensors/mcp2221a.h"

#include "drivers/height_decoders.h"
#include "sim/mcp2221a_model.h"
#include "tests/drivers/heights.h"
#include "tests/drivers/sensors/fake_link.h"

#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

using namespace std::chrono_literals;
using Bytes = FakeWire::Bytes;

DeviceInfo chip()
{
    return { .name = "MCP2221 USB-I2C/UART Combo",
             .location = "/dev/hidraw5",
             .vendor_id = 0x04D8,
             .product_id = 0x00DD };
}

// Fixture with the chip on a fake wire, and its wiper at 2 V of 5 V.
struct Mcp2221a : testing::Test {
    Mcp2221a()
    {
        for (int pin = 1; pin <= 3; ++pin)
            model.set_volts(pin, 2);
        wire.answer = [this](std::span<std::byte const> command) {
            auto const packet = model.answer(command);
            return Bytes(packet.begin(), packet.end());
        };
    }

    Result<std::unique_ptr<ReportSource>> open(Mcp2221aOptions const& options = {})
    {
        return open_mcp2221a(chip(), std::make_unique<FakeLink>(wire), options);
    }

    // Returns the counts of the next reading; -1 if there is none.
    static int read(ReportSource& source)
    {
        auto const report = source.read(100ms).value();
        if (!report)
            return -1;
        auto const decoder = make_height_decoder(source.info()).value();
        return decode_heights(*decoder, *report).value().at(0).counts;
    }

    // Returns a reply to a command of the kernel's driver.
    Bytes foreign(unsigned command)
    {
        auto const packet = model.answer(std::array { static_cast<std::byte>(command) });
        return { packet.begin(), packet.end() };
    }

    sim::Mcp2221aModel model;
    FakeWire wire;
};

TEST_F(Mcp2221a, ReadsThePinAgainstTheSupply)
{
    auto const source = open();
    ASSERT_TRUE(source) << source.error().message;
    EXPECT_EQ(read(**source), 409); // Expected is 2 V / 5 V * 1024.
    EXPECT_EQ((*source)->info().name, "MCP2221 USB-I2C/UART Combo, GP1");
}

TEST_F(Mcp2221a, ReadsAnotherPinAgainstAnotherReference)
{
    model.set_volts(3, 1);
    auto const source = open({ .pin = 3, .reference = Mcp2221aReference::Volts2048 });
    ASSERT_TRUE(source);
    EXPECT_EQ(read(**source), 500); // Expected is 1 V / 2.048 V * 1024.
    EXPECT_EQ((*source)->info().name,
              "MCP2221 USB-I2C/UART Combo, GP3, 0.002 V per count from 0 V");
}

TEST_F(Mcp2221a, SetsPinAndReferenceInOneCommandAndKeepsTheOtherPins)
{
    model = sim::Mcp2221aModel({ .pins = { 1, 8, 0x10, 3 } });
    ASSERT_TRUE(open({ .pin = 1, .reference = Mcp2221aReference::Volts4096 }));
    ASSERT_EQ(wire.commands.size(), 2u);
    EXPECT_EQ(wire.commands[0][0], std::byte { 0x61 });
    EXPECT_EQ(wire.commands[1][0], std::byte { 0x60 });
    EXPECT_EQ(wire.commands[1][5], std::byte { 0x87 });
    EXPECT_EQ(wire.commands[1][7], std::byte { 0x80 });
    EXPECT_EQ(Bytes(wire.commands[1].begin() + 8, wire.commands[1].begin() + 12),
              (Bytes { std::byte { 1 }, std::byte { 2 }, std::byte { 0x10 }, std::byte { 3 } }));
}

TEST_F(Mcp2221a, ReadsFiveHundredTimesASecond)
{
    auto const source = open().value();
    auto const start = wire.now;
    int reports = 0;
    while (wire.now < start + 1s)
        reports += source->read(10ms).value().has_value();
    EXPECT_NEAR(reports, 500, 1);
}

TEST_F(Mcp2221a, WaitsNoLongerThanItIsTold)
{
    auto const source = open().value();
    ASSERT_TRUE(source->read(10ms).value());
    auto const start = wire.now;
    EXPECT_FALSE(source->read(500us).value());
    EXPECT_EQ(wire.now, start + 500us);
}

TEST_F(Mcp2221a, PassesOverTheKernelsAnswers)
{
    auto const source = open().value();
    wire.disturb = [&](Bytes answer) {
        return std::vector<Bytes> { foreign(0x51), foreign(0x90), std::move(answer) };
    };
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(read(*source), 409);
}

TEST_F(Mcp2221a, DoesNotTakeAnOldAnswerForANewOne)
{
    auto const source = open().value();
    EXPECT_EQ(read(*source), 409);
    wire.intrude(foreign(0x10)); // A reply from the time when the wiper was at 2 V.
    model.set_volts(1, 3);
    EXPECT_EQ(read(*source), 614);
}

TEST_F(Mcp2221a, MakesItsSettingsAgainWhenTheKernelHasChangedThem)
{
    auto const source = open({ .reference = Mcp2221aReference::Volts4096 }).value();
    EXPECT_EQ(read(*source), 500);
    // The kernel's driver makes GP0 an output, and the reference is reset to the supply.
    std::array<std::byte, 64> command { std::byte { 0x60 } };
    command[7] = std::byte { 0x80 };
    command[9] = std::byte { 0x02 };
    auto const packet = model.answer(command);
    wire.intrude({ packet.begin(), packet.end() });
    EXPECT_EQ(read(*source), 500);
    EXPECT_EQ(read(*source), 500);
}

TEST_F(Mcp2221a, AsksAgainWhenAnAnswerIsLost)
{
    auto const source = open().value();
    int answers = 0;
    wire.disturb = [&](Bytes answer) {
        return ++answers % 2 ? std::vector<Bytes>() : std::vector<Bytes> { std::move(answer) };
    };
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(read(*source), 409);
}

TEST_F(Mcp2221a, OpensThoughAnswersAreLostOrCutOff)
{
    int answers = 0;
    wire.disturb = [&](Bytes answer) {
        if (++answers % 3 == 1)
            return std::vector<Bytes>();
        if (answers % 3 == 2)
            answer.resize(20);
        return std::vector<Bytes> { std::move(answer) };
    };
    ASSERT_TRUE(open());
    wire.disturb = {};
    EXPECT_EQ(model.counts(1), 409);
}

TEST_F(Mcp2221a, GivesASilentChipUpAfterASecond)
{
    auto const source = open().value();
    wire.disturb = [](Bytes const&) { return std::vector<Bytes>(); };
    auto const start = wire.now;
    Result<std::optional<RawReport>> report;
    while ((report = source->read(20ms)) && wire.now < start + 10s)
        EXPECT_FALSE(*report);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().fault, Fault::Device);
    EXPECT_EQ(report.error().message,
              "MCP2221 USB-I2C/UART Combo, GP1 at /dev/hidraw5 has not answered for a second "
              "(unplug it, and plug it in again)");
    EXPECT_LT(wire.now, start + 1200ms);
}

TEST_F(Mcp2221a, SaysThatItWasUnplugged)
{
    auto const source = open().value();
    EXPECT_EQ(read(*source), 409);
    wire.is_plugged = false;
    EXPECT_FALSE(source->read(10ms));
}

TEST_F(Mcp2221a, BlamesAChipThatRefuses)
{
    wire.answer = [](std::span<std::byte const> command) {
        Bytes packet(64);
        packet[0] = command[0];
        packet[1] = std::byte { 1 };
        return packet;
    };
    auto const source = open();
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().message,
              "MCP2221 USB-I2C/UART Combo at /dev/hidraw5 refuses command 61 with code 01");
}

TEST_F(Mcp2221a, BlamesTheUserForAPinWithoutConverter)
{
    auto const source = open({ .pin = 0 });
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().fault, Fault::User);
}

TEST(Mcp2221aOptions, AreReadFromAnAddress)
{
    auto const none = parse_mcp2221a_options("").value();
    EXPECT_EQ(none.pin, 1);
    EXPECT_EQ(none.reference, Mcp2221aReference::Supply);
    auto const both = parse_mcp2221a_options("4.096V,GP3").value();
    EXPECT_EQ(both.pin, 3);
    EXPECT_EQ(both.reference, Mcp2221aReference::Volts4096);
    auto const wrong = parse_mcp2221a_options("GP0");
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().fault, Fault::User);
    EXPECT_EQ(wrong.error().message,
              "'GP0' is no setting of the MCP2221A: expected GP1 to GP3, VDD, 1.024V, 2.048V or "
              "4.096V");
}

TEST_F(Mcp2221a, DecoderRefusesWhatTheChipCannotSay)
{
    auto const decoder = make_height_decoder(chip()).value();
    Bytes status(64);
    status[0] = std::byte { 0x10 };
    status[51] = std::byte { 0x04 }; // A reading of 1024 counts.
    EXPECT_FALSE(decode_heights(*decoder, {}, status));
    status[51] = std::byte { 0x03 };
    EXPECT_EQ(decode_heights(*decoder, {}, status).value().at(0).counts, 768);
    status.resize(52);
    auto const cut = decode_heights(*decoder, {}, status);
    ASSERT_FALSE(cut);
    EXPECT_EQ(cut.error().message, "MCP2221A status: 52 bytes, expected 64");
}

} // namespace
} // namespace tractus::drivers
