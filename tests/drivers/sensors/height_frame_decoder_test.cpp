#include "drivers/sensors/height_frame_decoder.h"

#include "drivers/height_decoders.h"
#include "drivers/sensors/height_frame_parser.h"
#include "engine/base/random.h"
#include "sim/height_sensor_frames.h"
#include "tests/drivers/bytes.h"
#include "tests/drivers/heights.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <string_view>

namespace tractus::drivers {
namespace {

using namespace std::chrono_literals;

std::unique_ptr<HeightDecoder> make_decoder()
{
    return make_height_frame_decoder(sim::HeightSensorModel().info()).value();
}

// Returns a frame with two readings that are a millisecond apart.
HeightFrame frame(std::uint16_t sequence)
{
    HeightFrame made {
        .sequence = sequence, .device_us = 1000 + 2000u * sequence, .period_us = 1000, .count = 2
    };
    made.counts[0] = static_cast<std::uint16_t>(2 * sequence % 4096);
    made.counts[1] = static_cast<std::uint16_t>(2 * sequence % 4096 + 1);
    return made;
}

Timestamp arrival(std::uint16_t sequence)
{
    return Timestamp(1s + 2ms * sequence);
}

std::vector<std::byte> joined(std::vector<std::vector<std::byte>> const& parts)
{
    std::vector<std::byte> all;
    for (auto const& part : parts)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

std::vector<int> counts_of(std::vector<HeightSample> const& samples)
{
    std::vector<int> counts;
    for (auto const& sample : samples)
        counts.push_back(sample.counts);
    return counts;
}

TEST(HeightFrame, CrcIsTheOneOfTheProtocol)
{
    std::string_view const text = "123456789";
    EXPECT_EQ(height_frame_crc(std::as_bytes(std::span(text))), 0x29B1);
    EXPECT_EQ(height_frame_crc({}), 0xFFFF);
}

// Compares a frame with the example in the protocol's documentation.
TEST(HeightFrame, IsLaidOutAsTheProtocolSays)
{
    HeightFrame made { .flags = kHeightFrameStart,
                       .sequence = 0x0102,
                       .device_us = 0x00112233,
                       .period_us = 1000,
                       .count = 2,
                       .counts = { 0x0234, 0x0235 } };
    EXPECT_EQ(sim::encode_height_frame(made),
              bytes("54 52 48 01 01 02 02 01 33 22 11 00 e8 03 34 02 35 02 a2 da"));
}

TEST(HeightFrameDecoder, KnowsTheSensorByItsString)
{
    auto info = sim::HeightSensorModel().info();
    EXPECT_TRUE(is_height_frame_device(info));
    EXPECT_EQ(make_height_decoder(info).value()->full_scale(), 4095);
    info.strings.clear();
    EXPECT_FALSE(is_height_frame_device(info));
    EXPECT_FALSE(make_height_frame_decoder(info));
}

TEST(HeightFrameDecoder, BlamesTheDeviceForAStringWithoutFullScale)
{
    DeviceInfo const info { .name = "Sensor",
                            .strings = { { 4, "tractus height sensor 1, full scale 0" } } };
    auto const decoder = make_height_frame_decoder(info);
    ASSERT_FALSE(decoder);
    EXPECT_EQ(decoder.error().fault, Fault::Device);
    EXPECT_EQ(decoder.error().message,
              "Sensor calls itself \"tractus height sensor 1, full scale 0\": expected a full "
              "scale of 1 to 65535 at its end");
}

TEST(HeightFrameDecoder, GivesEveryReadingItsTime)
{
    auto const decoder = make_decoder();
    auto const samples = decode_heights(*decoder, arrival(0), sim::encode_height_frame(frame(0)));
    ASSERT_TRUE(samples) << samples.error().message;
    EXPECT_EQ(counts_of(*samples), (std::vector { 0, 1 }));
    EXPECT_EQ(samples->at(0).full_scale, 4095);
    EXPECT_EQ(samples->at(1).time, arrival(0)); // A frame is sent when its last reading is taken.
    EXPECT_EQ(samples->at(0).time, arrival(0) - 1ms);
}

TEST(HeightFrameDecoder, ALateFrameDoesNotMoveTheHeight)
{
    auto const decoder = make_decoder();
    decode_heights(*decoder, arrival(0), sim::encode_height_frame(frame(0))).value();
    auto const late
        = decode_heights(*decoder, arrival(1) + 40ms, sim::encode_height_frame(frame(1)));
    EXPECT_EQ(late.value().at(1).time, arrival(1));
}

TEST(HeightFrameDecoder, JoinsFramesThatComeInPieces)
{
    auto const decoder = make_decoder();
    auto const whole
        = joined({ sim::encode_height_frame(frame(0)), sim::encode_height_frame(frame(1)) });
    std::vector<HeightSample> samples;
    for (std::size_t at = 0; at < whole.size(); at += 7)
        ASSERT_TRUE(decoder->decode(
            arrival(1), std::span(whole).subspan(at, std::min<std::size_t>(7, whole.size() - at)),
            samples));
    EXPECT_EQ(counts_of(samples), (std::vector { 0, 1, 2, 3 }));
    EXPECT_EQ(decoder->stream_counts().frames, 2u);
}

TEST(HeightFrameDecoder, CountsLostFrames)
{
    auto const decoder = make_decoder();
    for (auto const sequence : std::to_array<std::uint16_t>({ 0, 1, 4, 5, 9 }))
        decode_heights(*decoder, arrival(sequence), sim::encode_height_frame(frame(sequence)))
            .value();
    EXPECT_EQ(decoder->stream_counts().frames, 5u);
    EXPECT_EQ(decoder->stream_counts().lost_frames, 5u);
    EXPECT_EQ(decoder->stream_counts().clock_restarts, 0u);
}

TEST(HeightFrameDecoder, CountsOnWhenTheSequenceWraps)
{
    auto const decoder = make_decoder();
    auto last = frame(0xFFFF);
    auto next = frame(0);
    next.device_us = last.device_us + 2000;
    decode_heights(*decoder, arrival(0), sim::encode_height_frame(last)).value();
    decode_heights(*decoder, arrival(1), sim::encode_height_frame(next)).value();
    EXPECT_EQ(decoder->stream_counts().lost_frames, 0u);
}

TEST(HeightFrameDecoder, SurvivesACorruptFrame)
{
    auto const decoder = make_decoder();
    auto broken = sim::encode_height_frame(frame(1));
    broken[15] ^= std::byte { 0x10 };
    std::vector<HeightSample> samples;
    EXPECT_TRUE(decoder->decode(arrival(0), sim::encode_height_frame(frame(0)), samples));
    auto const result = decoder->decode(arrival(1), broken, samples);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, Fault::Device);
    EXPECT_EQ(result.error().message, "height sensor: the checksum of a frame is wrong");
    EXPECT_TRUE(decoder->decode(arrival(2), sim::encode_height_frame(frame(2)), samples));
    EXPECT_EQ(counts_of(samples), (std::vector { 0, 1, 4, 5 }));
    EXPECT_EQ(decoder->stream_counts().corrupt_frames, 1u);
    EXPECT_EQ(decoder->stream_counts().lost_frames, 1u);
}

TEST(HeightFrameDecoder, FindsTheNextFrameBehindGarbage)
{
    auto const decoder = make_decoder();
    // The stream contains a wrong magic number, half a frame, and bytes that look like the
    // beginning of a frame.
    auto half = sim::encode_height_frame(frame(0));
    half.resize(9);
    auto const mixed = joined({ bytes("00 54 52 ff"), half, bytes("54 52 48 01 00 ff"),
                                sim::encode_height_frame(frame(1)), bytes("aa bb") });
    std::vector<HeightSample> samples;
    auto const result = decoder->decode(arrival(1), mixed, samples);
    ASSERT_FALSE(result);
    EXPECT_EQ(counts_of(samples), (std::vector { 2, 3 }));
    EXPECT_TRUE(decoder->decode(arrival(2), sim::encode_height_frame(frame(2)), samples));
    EXPECT_EQ(counts_of(samples), (std::vector { 2, 3, 4, 5 }));
}

TEST(HeightFrameDecoder, GivesTheGoodFramesOfABrokenReport)
{
    auto const decoder = make_decoder();
    auto broken = sim::encode_height_frame(frame(1));
    broken[18] ^= std::byte { 1 };
    std::vector<HeightSample> samples;
    EXPECT_FALSE(decoder->decode(
        arrival(2),
        joined({ sim::encode_height_frame(frame(0)), broken, sim::encode_height_frame(frame(2)) }),
        samples));
    EXPECT_EQ(counts_of(samples), (std::vector { 0, 1, 4, 5 }));
}

TEST(HeightFrameDecoder, RefusesReadingsBeyondFullScale)
{
    auto const decoder = make_decoder();
    auto beyond = frame(3);
    beyond.counts[1] = 4096;
    auto const samples = decode_heights(*decoder, arrival(3), sim::encode_height_frame(beyond));
    ASSERT_FALSE(samples);
    EXPECT_EQ(samples.error().message,
              "height sensor frame 3: 4096 counts every 1000 us, expected 0 to 4095 counts");
    EXPECT_EQ(decoder->stream_counts().corrupt_frames, 1u);
}

TEST(HeightFrameDecoder, StartsAnewWhenTheSensorDoes)
{
    auto const decoder = make_decoder();
    decode_heights(*decoder, arrival(500), sim::encode_height_frame(frame(500))).value();
    auto restarted = frame(0);
    restarted.flags = kHeightFrameStart;
    auto const samples
        = decode_heights(*decoder, arrival(900), sim::encode_height_frame(restarted)).value();
    EXPECT_EQ(samples.at(1).time, arrival(900));
    EXPECT_EQ(decoder->stream_counts().clock_restarts, 1u);
    EXPECT_EQ(decoder->stream_counts().lost_frames, 0u);
}

TEST(HeightFrameDecoder, NoticesARestartThatIsNotTold)
{
    auto const decoder = make_decoder();
    decode_heights(*decoder, arrival(500), sim::encode_height_frame(frame(500))).value();
    auto const samples
        = decode_heights(*decoder, arrival(900), sim::encode_height_frame(frame(3))).value();
    EXPECT_EQ(samples.at(1).time, arrival(900));
    EXPECT_EQ(decoder->stream_counts().clock_restarts, 1u);
}

TEST(HeightFrameDecoder, CountsWhatTheSensorSaysOfItself)
{
    auto const decoder = make_decoder();
    auto told = frame(0);
    told.flags = kHeightFrameOverrun | kHeightFrameReferenceFault;
    decode_heights(*decoder, arrival(0), sim::encode_height_frame(told)).value();
    EXPECT_EQ(decoder->stream_counts().overruns, 1u);
    EXPECT_EQ(decoder->stream_counts().reference_faults, 1u);
}

TEST(HeightFrameDecoder, TimesNeverGoBack)
{
    auto const decoder = make_decoder();
    Random random({ .seed = 3 });
    std::vector<HeightSample> samples;
    for (std::uint16_t i = 0; i < 2000; ++i)
        (void)decoder->decode(arrival(i) + Duration(random.next_u32() % 5'000'000),
                              sim::encode_height_frame(frame(i % 700)), samples);
    for (std::size_t i = 1; i < samples.size(); ++i)
        ASSERT_GT(samples[i].time, samples[i - 1].time);
}

TEST(HeightFrameParser, HoldsBackAtMostOneFrame)
{
    // The stream consists of endless beginnings of frames. Each one is dropped when the next one
    // contradicts it.
    HeightFrameParser parser;
    std::vector<HeightFrame> frames;
    auto const beginning = bytes("54 52 48 01 00 17 00 00 00 00 00 00 e8 03");
    for (int i = 0; i < 100; ++i)
        parser.push(beginning, frames);
    EXPECT_TRUE(frames.empty());
    EXPECT_GT(parser.corrupt_frames(), 90u);
    HeightFrame one { .period_us = 1, .count = 1 };
    for (int i = 0; i < 4; ++i)
        parser.push(sim::encode_height_frame(one), frames);
    EXPECT_GE(frames.size(), 3u);
}

} // namespace
} // namespace tractus::drivers
