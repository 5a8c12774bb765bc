#include "drivers/gpio/gpio_encoder.h"
#include "drivers/height_decoders.h"
#include "drivers/logs/log.h"
#include "sim/height_curve.h"
#include "tests/vm/checks.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <fmt/core.h>
#include <memory>
#include <vector>

namespace tractus {

namespace {

struct DecodedHeights {
    std::vector<drivers::HeightSample> samples;
    drivers::HeightStreamCounts counts;
    std::size_t broken_reports = 0;
};

// Decodes the log's first height sensor.
Result<DecodedHeights> decode_heights(std::string const& log_name)
{
    auto const log = TRY(drivers::read_log(log_name));
    for (std::size_t device = 0; device < log.devices.size(); ++device) {
        auto const decoder = drivers::make_height_decoder(log.devices[device]);
        if (!decoder)
            continue;
        DecodedHeights heights;
        for (auto const& record : log.records)
            // Size 0 means that the device was disconnected.
            if (record.device == device && record.size > 0
                && !(*decoder)->decode(record.time, log.report(record), heights.samples))
                ++heights.broken_reports;
        heights.counts = (*decoder)->stream_counts();
        if (heights.samples.empty())
            return fail(Fault::Device, fmt::format("{}: the height sensor said nothing", log_name));
        return heights;
    }
    return fail(Fault::Device, fmt::format("{} has no height sensor", log_name));
}

// Returns the greatest distance of the samples from a curve that is delayed by `offset`, as a share
// of full scale.
double farthest(sim::HeightCurve const& curve, std::vector<drivers::HeightSample> const& samples,
                Duration offset)
{
    double far = 0;
    for (auto const& sample : samples)
        far = std::max(far,
                       std::abs(double(sample.counts) / sample.full_scale
                                - curve.fraction_at(sample.time - offset)));
    return far;
}

// Returns the greatest distance of the samples from a curve, with the delay for which it is least.
double farthest_at_best(sim::HeightCurve const& curve,
                        std::vector<drivers::HeightSample> const& samples)
{
    constexpr Duration kLargestOffset = std::chrono::seconds(3);
    double nearest = 1;
    for (auto offset = -kLargestOffset; offset < kLargestOffset;
         offset += std::chrono::milliseconds(1))
        nearest = std::min(nearest, farthest(curve, samples, offset));
    return nearest;
}

} // namespace

Result<void> compare_heights(std::string const& sent_name, std::string const& got_name,
                             double tolerance)
{
    auto const sent = TRY(drivers::read_log(sent_name));
    auto const curve = TRY(sim::HeightCurve::read(sent));
    auto const heights = TRY(decode_heights(got_name));
    if (heights.broken_reports > 0)
        return fail(Fault::Device, fmt::format("{} reports are broken", heights.broken_reports));
    double const nearest = farthest_at_best(curve, heights.samples);
    fmt::print("{} samples, full scale {}\n", heights.samples.size(),
               heights.samples.front().full_scale);
    print_figure("height error max", 100 * nearest, "% of full scale");
    if (nearest > tolerance)
        return fail(Fault::Device, "these are not the heights that were sent");
    return {};
}

Result<void> compare_encoder(std::string const& sent_name, std::string const& got_name,
                             unsigned counts)
{
    constexpr double kMaxBehind = 2;
    auto const sent = TRY(drivers::read_log(sent_name));
    auto const curve = TRY(sim::HeightCurve::read(sent));
    auto heights = TRY(decode_heights(got_name));
    if (heights.broken_reports > 0 || heights.counts.overruns > 0)
        return fail(Fault::Device,
                    fmt::format("{} reports are broken, {} edges were lost", heights.broken_reports,
                                heights.counts.overruns));
    auto const count_at = [&](Timestamp time) {
        return static_cast<std::int32_t>(std::floor(curve.fraction_at(time) * counts));
    };
    auto const first = count_at(Timestamp());
    for (auto& sample : heights.samples) { // The encoder's count is 0 at its first position.
        sample.counts += first - drivers::kEncoderCountsBelow;
        sample.full_scale = static_cast<std::int32_t>(counts);
    }
    double const farthest_counts = farthest_at_best(curve, heights.samples) * counts;
    auto const last = heights.samples.back().counts;
    fmt::print("{} samples, from count {} to {}\n", heights.samples.size(), first, last);
    print_figure("encoder behind by", farthest_counts, "counts");
    // Heights are rounded down to counts, which allows a difference of one count.
    if (farthest_counts > 1 + kMaxBehind)
        return fail(Fault::Device, "these are not the heights that were sent");
    if (last != count_at(curve.end()))
        return fail(Fault::Device, fmt::format("expected to end at {}", count_at(curve.end())));
    return {};
}

Result<void> check_height(std::string const& log_name, HeightExpectation const& expected)
{
    auto const heights = TRY(decode_heights(log_name));
    double mean = 0;
    for (auto const& sample : heights.samples)
        mean += double(sample.counts) / sample.full_scale / double(heights.samples.size());
    fmt::print("{} samples, {:.5f} of full scale in the mean\n", heights.samples.size(), mean);
    if (heights.broken_reports > 0)
        return fail(Fault::Device, fmt::format("{} reports are broken", heights.broken_reports));
    if (std::abs(mean - expected.fraction) > expected.tolerance)
        return fail(Fault::Device, fmt::format("expected {:.5f}", expected.fraction));
    return {};
}

Result<void> check_stream(std::string const& log_name, StreamExpectation const& expected)
{
    auto const heights = TRY(decode_heights(log_name));
    auto const& counts = heights.counts;
    fmt::print("{} frames with {} readings; {} lost, {} corrupt, {} bytes of garbage, {} overruns, "
               "{} restarts\n",
               counts.frames, heights.samples.size(), counts.lost_frames, counts.corrupt_frames,
               counts.garbage_bytes, counts.overruns, counts.clock_restarts);
    print_figure("frames", static_cast<double>(counts.frames), "");
    print_figure("lost frames", static_cast<double>(counts.lost_frames), "");
    if (counts.corrupt_frames > 0 || counts.garbage_bytes > 0 || heights.broken_reports > 0)
        return fail(Fault::Device, "there are broken frames");
    if (counts.lost_frames > expected.max_lost_frames)
        return fail(Fault::Device, fmt::format("more than {} lost", expected.max_lost_frames));
    if (counts.clock_restarts != expected.restarts)
        return fail(Fault::Device, fmt::format("expected {} restarts", expected.restarts));
    return {};
}

} // namespace tractus
