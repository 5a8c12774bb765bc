#include "drivers/height_decoder.h"
#include "drivers/log.h"
#include "tests/vm/checks.h"

#include <cmath>
#include <fmt/core.h>
#include <memory>
#include <vector>

namespace tractus {

namespace {

struct DecodedHeights {
    std::vector<HeightSample> samples;
    HeightStreamCounts counts;
    std::size_t broken_reports = 0;
};

// Of the log's first height sensor.
Result<DecodedHeights> decode_heights(std::string const& log_name)
{
    auto const log = TRY(read_log(log_name));
    for (std::size_t device = 0; device < log.devices.size(); ++device) {
        auto const decoder = make_height_decoder(log.devices[device]);
        if (!decoder)
            continue;
        DecodedHeights heights;
        for (auto const& record : log.records)
            if (record.device == device
                && !(*decoder)->decode(record.time, log.report(record), heights.samples))
                ++heights.broken_reports;
        heights.counts = (*decoder)->stream_counts();
        if (heights.samples.empty())
            return fail(Fault::Device, fmt::format("{}: the height sensor said nothing", log_name));
        return heights;
    }
    return fail(Fault::Device, fmt::format("{} has no height sensor", log_name));
}

} // namespace

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
