#include "drivers/height_decoders.h"
#include "sim/height_sensor_frames.h"
#include "tests/bench/report.h"

#include <vector>

namespace tractus {
namespace {

constexpr std::size_t kFrames = 200'000;
constexpr std::size_t kSamplesPerFrame = 5; // Number of readings in a frame, the sensor's default.
constexpr std::uint16_t kPeriodUs = 1000;

struct Frame {
    std::vector<std::byte> bytes;
    Timestamp arrival;
};

// Returns a quarter of an hour of frames from a sensor whose clock is slow by 200 ppm.
std::vector<Frame> const& frames()
{
    static auto const all = [] {
        std::vector<Frame> made;
        made.reserve(kFrames);
        drivers::HeightFrame frame { .period_us = kPeriodUs, .count = kSamplesPerFrame };
        for (std::size_t i = 0; i < kFrames; ++i) {
            for (std::size_t k = 0; k < kSamplesPerFrame; ++k)
                frame.counts[k] = static_cast<std::uint16_t>((i * kSamplesPerFrame + k) % 4096);
            frame.sequence = static_cast<std::uint16_t>(i);
            frame.device_us = static_cast<std::uint32_t>(i * kSamplesPerFrame * kPeriodUs);
            auto const late_us = static_cast<std::int64_t>(i * 7919 % 400);
            auto const sent_ns = static_cast<std::int64_t>(i * kSamplesPerFrame) * 1'000'200;
            made.push_back(
                { sim::encode_height_frame(frame), timestamp_ns(sent_ns + late_us * 1000) });
        }
        return made;
    }();
    return all;
}

void decode_height_frames(benchmark::State& state)
{
    auto const info = sim::HeightSensorModel().info();
    std::vector<drivers::HeightSample> samples;
    for (auto _ : state) {
        auto const decoder = *drivers::make_height_decoder(info);
        for (auto const& frame : frames()) {
            samples.clear();
            auto const decoded = decoder->decode(frame.arrival, frame.bytes, samples);
            benchmark::DoNotOptimize(decoded.has_value());
            benchmark::DoNotOptimize(samples.data());
        }
    }
    constexpr std::size_t kSamples = kFrames * kSamplesPerFrame;
    report(state,
           { .items = kSamples,
             .item = "samples",
             .bytes = static_cast<double>(kFrames * frames()[0].bytes.size()
                                          + kSamples * sizeof(drivers::HeightSample)) });
}
BENCHMARK(decode_height_frames);

} // namespace
} // namespace tractus
