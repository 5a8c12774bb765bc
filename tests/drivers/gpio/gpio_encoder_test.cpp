#include "drivers/gpio/gpio_encoder.h"

#include "drivers/device_list.h"
#include "drivers/height_decoders.h"
#include "sim/simulated_encoder.h"
#include "tests/drivers/bytes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

using namespace std::chrono_literals;

constexpr char kPlace[] = "gpio:pinctrl-bcm2711:17,27:quadrature";

std::unique_ptr<ReportSource> encoder(sim::SimulatedEncoder::Position position,
                                      sim::SimulatedEncoder::Options options = {})
{
    return open_gpio_encoder(
               { .location = kPlace },
               std::make_unique<sim::SimulatedEncoder>(std::move(position), std::move(options)))
        .value();
}

// Returns the position of a hand that moves up by 400 mm and down again in four seconds, at 0.05 mm
// a count: at most 6,283 edges a second.
double hand(Timestamp time)
{
    return 4000 - 4000 * std::cos(to_seconds(time) * kPi / 2);
}

// Samples read until a given time, and the decoder's errors.
struct Read {
    std::vector<HeightSample> samples;
    std::vector<std::string> errors;
    std::uint64_t overruns = 0;
};

Read read_until(ReportSource& source, Timestamp end)
{
    Read read;
    auto const decoder = make_height_decoder(source.info()).value();
    Timestamp last {};
    while (last < end) {
        auto const report = source.read(100ms);
        if (!report) {
            read.errors.push_back(report.error().message);
            break;
        }
        if (!*report)
            continue;
        last = (*report)->received;
        if (auto const decoded = decoder->decode(**report, read.samples); !decoded)
            read.errors.push_back(decoded.error().message);
    }
    read.overruns = decoder->stream_counts().overruns;
    return read;
}

TEST(GpioEncoder, FollowsAHandToTheCount)
{
    auto const source = encoder(hand);
    auto const read = read_until(*source, timestamp_ns(4'000'000'000));
    EXPECT_TRUE(read.errors.empty());
    ASSERT_GT(read.samples.size(), 1500u);
    for (auto const& sample : read.samples)
        // A sample's time is that of an edge, to within a step of the simulation. In a step the
        // encoder may move by a fraction of a count.
        EXPECT_NEAR(sample.counts - kEncoderCountsBelow, hand(sample.time), 1.2);
    EXPECT_EQ(read.samples.front().full_scale, kEncoderFullScale);
}

TEST(GpioEncoder, HasTimesThatNeverGoBack)
{
    auto const source = encoder(hand);
    auto const samples = read_until(*source, timestamp_ns(1'000'000'000)).samples;
    for (std::size_t i = 1; i < samples.size(); ++i)
        EXPECT_GT(samples[i].time, samples[i - 1].time);
}

TEST(GpioEncoder, TellsItsHeightWhileItRests)
{
    auto const source = encoder([](Timestamp) { return 12.5; });
    auto const read = read_until(*source, timestamp_ns(1'000'000'000));
    EXPECT_NEAR(static_cast<double>(read.samples.size()), 100, 1);
    // Counting starts where the encoder was at the beginning.
    EXPECT_EQ(read.samples.back().counts, kEncoderCountsBelow);
}

TEST(GpioEncoder, SaysOnceThatAnEdgeWasLostAndGoesOn)
{
    auto const source = encoder(hand, { .lost = { 1000, 1001 } });
    auto const read = read_until(*source, timestamp_ns(2'000'000'000));
    ASSERT_EQ(read.errors.size(), 1u);
    EXPECT_EQ(read.errors[0],
              "the encoder has lost 2 edges, so its height is no longer true: set the surface to "
              "where it was at the beginning, and calibrate zero");
    EXPECT_EQ(read.overruns, 1u);
    EXPECT_GT(read.samples.size(), 800u);
}

TEST(GpioEncoder, NoticesAnEdgeThatNobodyNumbered)
{
    auto const source = encoder(hand, { .unnumbered = { 500 } });
    auto const read = read_until(*source, timestamp_ns(2'000'000'000));
    EXPECT_EQ(read.errors.size(), 1u);
}

TEST(GpioEncoder, FailsWhenTheChipIsGone)
{
    auto const source = encoder(hand, { .gone_after = 100 });
    auto const read = read_until(*source, timestamp_ns(2'000'000'000));
    ASSERT_EQ(read.errors.size(), 1u);
    EXPECT_EQ(read.errors[0], "lost the lines of the GPIO chip: it is gone");
}

TEST(GpioEncoder, WaitsNoLongerThanItIsTold)
{
    sim::SimulatedEncoder* lines = nullptr;
    auto owned = std::make_unique<sim::SimulatedEncoder>([](Timestamp) { return 0.0; },
                                                         sim::SimulatedEncoder::Options {});
    lines = owned.get();
    auto const source = open_gpio_encoder({ .location = kPlace }, std::move(owned)).value();
    EXPECT_FALSE(source->read(4ms).value());
    EXPECT_EQ(lines->now(), timestamp_ns(4'000'000));
}

// The report's bytes mean 260 counts below the beginning, after three edges.
TEST(GpioEncoderDecoder, ReadsTheReportsBytes)
{
    auto const decoder = make_gpio_encoder_decoder();
    std::vector<HeightSample> samples;
    ASSERT_TRUE(decoder->decode({}, bytes("00 00 03 00 fc fe ff ff"), samples));
    EXPECT_EQ(samples.at(0).counts, kEncoderCountsBelow - 260);
    EXPECT_EQ(decoder->decode({}, bytes("00 00 03"), samples).error().message,
              "encoder report: 3 bytes, expected 8");
    EXPECT_EQ(decoder->decode({}, bytes("00 00 03 00 00 00 00 7f"), samples).error().message,
              "encoder report: it has counted 2130706432, expected -1048576 to 1048575");
}

TEST(GpioEncoder, IsKnownByItsAddressAlone)
{
    auto const info = find_device(kPlace);
    ASSERT_TRUE(info) << info.error().message;
    EXPECT_EQ(info->name, "Quadrature encoder on pinctrl-bcm2711");
    EXPECT_TRUE(is_gpio_encoder(*info));
    auto const nowhere = open_device({ .location = "gpio:no such chip:17,27:quadrature" });
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().fault, Fault::User);
}

} // namespace
} // namespace tractus::drivers
