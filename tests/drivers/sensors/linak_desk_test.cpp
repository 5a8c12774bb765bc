#include "drivers/sensors/linak_desk.h"

#include "drivers/height_decoders.h"
#include "sim/linak_desk_model.h"
#include "tests/drivers/bytes.h"
#include "tests/drivers/heights.h"
#include "tests/drivers/sensors/fake_link.h"

#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

using namespace std::chrono_literals;
using Bytes = FakeWire::Bytes;

// Fixture with a desk on a fake wire, 312.4 mm above its lowest position.
struct LinakDesk : testing::Test {
    LinakDesk()
    {
        desk.move_to(3124);
        wire.answer = [this](std::span<std::byte const> command) {
            if (command.size() == 1)
                return desk.get_feature(std::to_integer<std::uint8_t>(command[0])).value();
            EXPECT_TRUE(desk.set_feature(command));
            // The desk sends an unexpected packet, which counts as no answer.
            return Bytes { std::byte { 0x99 } };
        };
    }

    Result<std::unique_ptr<ReportSource>> open()
    {
        return open_linak_desk({ .name = "USB Control Link",
                                 .location = "/dev/hidraw3",
                                 .vendor_id = 0x12d3,
                                 .product_id = 0x0002 },
                               std::make_unique<FakeLink>(wire));
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

    sim::LinakDeskModel desk;
    FakeWire wire;
};

TEST_F(LinakDesk, TellsItsHeightInTenthsOfAMillimetre)
{
    auto const source = open();
    ASSERT_TRUE(source) << source.error().message;
    EXPECT_EQ(read(**source), 3124 + kLinakCountsBelow);
    desk.move_to(0);
    EXPECT_EQ(read(**source), kLinakCountsBelow);
}

// In users' recordings of desks, the host sends feature 3, feature 5 with four times 0x8001, and
// nothing else.
TEST_F(LinakDesk, IsInitialisedAndNeverMoved)
{
    auto const source = open().value();
    for (int i = 0; i < 100; ++i)
        ASSERT_NE(read(*source), -1);
    std::vector<Bytes> set;
    for (auto const& command : wire.commands)
        if (command.size() > 1)
            set.push_back(command);
    ASSERT_EQ(set.size(), 2u);
    EXPECT_EQ(set[0].size(), 64u);
    EXPECT_EQ(Bytes(set[0].begin(), set[0].begin() + 6), bytes("03 04 00 fb 00 00"));
    EXPECT_EQ(Bytes(set[1].begin(), set[1].begin() + 10), bytes("05 01 80 01 80 01 80 01 80 00"));
    EXPECT_EQ(desk.movement_count(), 0u);
}

TEST_F(LinakDesk, IsNotInitialisedWhereItKnowsItsHeight)
{
    ASSERT_TRUE(open());
    wire.commands.clear();
    ASSERT_TRUE(open());
    for (auto const& command : wire.commands)
        EXPECT_EQ(command.size(), 1u);
}

TEST_F(LinakDesk, IsInitialisedAgainWhenItsPowerWasGone)
{
    auto const source = open().value();
    ASSERT_NE(read(*source), -1);
    desk.lose_power();
    int counts = -1;
    for (int i = 0; i < 5 && counts == -1; ++i)
        counts = read(*source);
    EXPECT_EQ(counts, 3124 + kLinakCountsBelow);
}

TEST_F(LinakDesk, IsAskedFiftyTimesASecond)
{
    auto const source = open().value();
    auto const start = wire.now;
    int reports = 0;
    while (wire.now < start + 1s)
        reports += source->read(10ms).value().has_value();
    EXPECT_NEAR(reports, 50, 1);
}

TEST_F(LinakDesk, SaysWhatToDoWithADeskThatHasLostItsPlace)
{
    desk.lose_position();
    auto const source = open();
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().fault, Fault::User);
    EXPECT_EQ(source.error().message,
              "the desk at /dev/hidraw3 does not know how high it is: hold its own down key until "
              "it is at its lowest and for ten seconds more, and try again");
    EXPECT_EQ(desk.movement_count(), 0u);
}

TEST_F(LinakDesk, SaysThatItIsUnplugged)
{
    auto const source = open().value();
    wire.is_plugged = false;
    EXPECT_FALSE(source->read(100ms));
}

// The report's bytes are those of a sinking desk at 600.0 mm.
TEST(LinakDeskDecoder, ReadsTheAnswersBytes)
{
    auto const decoder = make_linak_desk_decoder();
    std::vector<HeightSample> samples;
    ASSERT_TRUE(decoder->decode({}, bytes("04 38 01 00 70 17 e0 01"), samples));
    ASSERT_EQ(samples.size(), 1u);
    EXPECT_EQ(samples[0].counts, 6000 + kLinakCountsBelow);
    EXPECT_EQ(samples[0].full_scale, kLinakFullScale);
    ASSERT_TRUE(decoder->decode({}, bytes("04 38 01 00 ff ff f0 00"), samples));
    // The desk may sink slightly below its lowest position.
    EXPECT_EQ(samples[1].counts, -1 + kLinakCountsBelow);
}

TEST(LinakDeskDecoder, RefusesWhatIsBroken)
{
    auto const decoder = make_linak_desk_decoder();
    std::vector<HeightSample> samples;
    auto const refuses = [&](std::vector<std::byte> const& report, std::string const& why) {
        auto const decoded = decoder->decode({}, report, samples);
        ASSERT_FALSE(decoded);
        EXPECT_EQ(decoded.error().fault, Fault::Device);
        EXPECT_EQ(decoded.error().message, "desk status: " + why);
    };
    refuses(bytes("04 38 01"), "3 bytes, expected 64 that begin with 04 38");
    refuses(bytes("04 37 01 00 70 17 e0 01"), "8 bytes, expected 64 that begin with 04 38");
    refuses(bytes("04 38 00 00 00 00 00 00"), "the desk does not know how high it is");
    refuses(bytes("04 38 01 00 ff 7f f0 00"),
            "32767 tenths of a millimetre, expected -100 to 10000");
    EXPECT_TRUE(decoder->decode({}, bytes("01 02"), samples)); // Another report of the cable.
    EXPECT_TRUE(samples.empty());
}

} // namespace
} // namespace tractus::drivers
