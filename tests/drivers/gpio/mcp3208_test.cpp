#include "drivers/gpio/mcp3208.h"

#include "tests/drivers/gpio/simulated_converter.h"

#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr unsigned kRequests = 51; // Number of requests for one conversion of 12 bits.

// Index of the request that ends the sampling. Before it, CS goes low, the command takes ten
// requests, and CLK rises once.
constexpr std::uint64_t kSamplingEnds = 12;

constexpr Mcp3208Channel kFirst { .bits = 12, .channel = 0 };

TEST(Mcp3208, ReadsEveryCodeOfTwelveBits)
{
    SimulatedConverter converter;
    for (int code = 0; code < 4096; ++code) {
        converter.inputs[0] = (code + 0.5) / 4096;
        auto const reading = converter.convert(kFirst);
        ASSERT_TRUE(reading) << reading.error().message;
        EXPECT_TRUE(reading->is_answered);
        ASSERT_EQ(reading->counts, code);
    }
}

TEST(Mcp3208, ReadsEveryCodeOfTenBits)
{
    SimulatedConverter converter({ .bits = 10 });
    for (int code = 0; code < 1024; ++code) {
        converter.inputs[0] = (code + 0.5) / 1024;
        ASSERT_EQ(converter.convert({ .bits = 10, .channel = 0 })->counts, code);
    }
}

TEST(Mcp3208, ReadsEachChannelByItself)
{
    SimulatedConverter converter;
    for (unsigned i = 0; i < 8; ++i)
        converter.inputs[i] = (100.0 * i + 0.5) / 4096;
    for (unsigned i = 0; i < 8; ++i)
        EXPECT_EQ(converter.convert({ .bits = 12, .channel = i })->counts,
                  static_cast<int>(100 * i));
}

TEST(Mcp3208, TakesFiftyOneRequestsAndNoMore)
{
    SimulatedConverter converter;
    ASSERT_TRUE(converter.convert(kFirst));
    EXPECT_EQ(converter.lines.requests(), kRequests);
}

TEST(Mcp3208, TellsWhenTheConverterSampled)
{
    SimulatedConverter converter({}, { .request_time = microseconds(10) });
    auto const reading = converter.convert(kFirst);
    EXPECT_EQ(reading->sampled, Timestamp((kSamplingEnds + 1) * microseconds(10)));
    EXPECT_EQ(reading->held, (kRequests - 1 - kSamplingEnds) * microseconds(10));
}

TEST(Mcp3208, NoticesAnInterruptionWhileTheReadingIsHeld)
{
    SimulatedConverter converter({}, { .pauses = { { kSamplingEnds + 5, milliseconds(20) } } });
    converter.inputs[0] = 2500.5 / 4096;
    auto const interrupted = converter.convert(kFirst);
    EXPECT_GT(interrupted->held, kMcp3208HoldLimit);
    EXPECT_LT(interrupted->counts, 2490) << "the capacitor leaks";
    auto const again = converter.convert(kFirst);
    EXPECT_LT(again->held, kMcp3208HoldLimit);
    EXPECT_EQ(again->counts, 2500);
}

TEST(Mcp3208, DoesNotMindAnInterruptionBeforeTheSampling)
{
    SimulatedConverter converter({}, { .pauses = { { kSamplingEnds - 3, milliseconds(20) } } });
    converter.inputs[0] = 2500.5 / 4096;
    auto const reading = converter.convert(kFirst);
    EXPECT_LT(reading->held, kMcp3208HoldLimit);
    EXPECT_EQ(reading->counts, 2500);
}

TEST(Mcp3208, ReadsTheNextConversionRightAfterABrokenOffOne)
{
    SimulatedConverter converter;
    converter.inputs[0] = 2500.5 / 4096;
    // Another program left the converter in the middle of a conversion.
    converter.model.set_pins(timestamp_ns(1), { .clk = false, .din = true, .cs = false });
    converter.model.set_pins(timestamp_ns(2), { .clk = true, .din = true, .cs = false });
    ASSERT_TRUE(converter.lines.set(8)) << "CS goes high, as when the lines are opened";
    EXPECT_EQ(converter.convert(kFirst)->counts, 2500);
}

TEST(Mcp3208, SaysThatNothingAnswersOnABrokenWire)
{
    using enum sim::Mcp3208Model::Wire;
    for (auto const wire : { Clk, Din, Dout, Cs }) {
        SimulatedConverter converter({}, { .dout_pull = true });
        converter.model.break_wire(wire);
        auto const reading = converter.convert(kFirst);
        ASSERT_TRUE(reading);
        EXPECT_FALSE(reading->is_answered) << static_cast<int>(wire);
    }
}

TEST(Mcp3208, FailsWhenTheChipIsUnplugged)
{
    for (bool const swallows : { false, true })
        for (std::uint64_t gone_at = 0; gone_at + 1 < kRequests; ++gone_at) {
            SimulatedConverter converter({},
                                         { .gone_at = gone_at, .swallows_failing_sets = swallows });
            auto const reading = converter.convert(kFirst);
            ASSERT_FALSE(reading) << gone_at;
            EXPECT_EQ(reading.error().fault, Fault::Device);
        }
}

} // namespace
} // namespace tractus::drivers
