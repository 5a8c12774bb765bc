#include "calib/height_capture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>

namespace tractus::calib {

std::vector<HeightCapture> captures_without(std::span<HeightCapture const> captures,
                                            std::span<std::size_t const> left_out)
{
    std::vector<HeightCapture> rest;
    for (std::size_t i = 0; i < captures.size(); ++i)
        if (std::find(left_out.begin(), left_out.end(), i) == left_out.end())
            rest.push_back(captures[i]);
    return rest;
}

ReadingRange reading_range(std::span<HeightCapture const> captures)
{
    auto const [low, high]
        = std::minmax_element(captures.begin(), captures.end(),
                              [](auto const& a, auto const& b) { return a.counts < b.counts; });
    return { low->counts, high->counts };
}

namespace {

constexpr std::size_t kMinReadings = 20;
constexpr Duration kLongestCaptureGap = std::chrono::milliseconds(250);
constexpr std::size_t kBlocks = 8;
constexpr int kScatterReach = 12; // Number of histogram bins on either side of the middle one.

// Statistics of readings from a resting carriage.
struct Statistics {
    double mean = 0;
    double deviation = 0; // Standard deviation of the readings.
    // Noise estimated from differences of neighbouring readings, so that slow movement does not
    // count.
    double noise = 0;
    std::array<double, kBlocks> block_means {};
    std::size_t on_low_rail = 0;
    std::size_t on_high_rail = 0;
};

Statistics statistics(std::span<drivers::HeightSample const> samples)
{
    Statistics result;
    auto const count = static_cast<double>(samples.size());
    for (auto const& sample : samples) {
        result.mean += sample.counts; // Sums of whole numbers are exact.
        result.on_low_rail += sample.counts <= 0;
        result.on_high_rail += sample.counts >= sample.full_scale;
    }
    result.mean /= std::max(1.0, count);
    double squares = 0;
    double difference_squares = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        double const deviation = samples[i].counts - result.mean;
        squares += deviation * deviation;
        if (i > 0) {
            double const difference = samples[i].counts - samples[i - 1].counts;
            difference_squares += difference * difference;
        }
    }
    double const degrees = std::max(1.0, count - 1);
    result.deviation = std::sqrt(squares / degrees);
    result.noise = std::sqrt(difference_squares / (2 * degrees));
    for (std::size_t block = 0; block < kBlocks; ++block) {
        auto const begin = samples.size() * block / kBlocks;
        auto const end = samples.size() * (block + 1) / kBlocks;
        for (auto i = begin; i < end; ++i)
            result.block_means[block] += samples[i].counts / static_cast<double>(end - begin);
    }
    return result;
}

// Returns how far the carriage moved, in counts.
double movement(Statistics const& statistics)
{
    auto const [least, greatest]
        = std::minmax_element(statistics.block_means.begin(), statistics.block_means.end());
    return *greatest - *least;
}

double allowed_movement(Statistics const& statistics, std::size_t readings, std::int32_t full_scale)
{
    double const block_noise
        = statistics.noise / std::sqrt(static_cast<double>(readings) / kBlocks);
    return std::max({ 2.0, full_scale / 2048.0, 6 * block_noise });
}

double allowed_noise(std::int32_t full_scale)
{
    return std::max(8.0, full_scale / 200.0);
}

// True if more than 1 % of the readings are at the converter's limit. Fewer may be noise near the
// limit.
bool is_on_rail(std::size_t readings_there, std::size_t readings)
{
    return readings_there * 100 > readings;
}

tl::unexpected<Error> on_rail(Statistics const& seen,
                              std::span<drivers::HeightSample const> samples)
{
    bool const is_low = is_on_rail(seen.on_low_rail, samples.size());
    return fail(Fault::User,
                fmt::format("the reading is at the {} end of the converter ({} of {}), where it "
                            "says nothing: move the surface away from there, or check the wiring "
                            "if it is so at every height",
                            is_low ? "lower" : "upper", is_low ? 0 : samples.front().full_scale,
                            samples.front().full_scale));
}

Duration longest_gap(std::span<drivers::HeightSample const> samples)
{
    Duration gap {};
    for (std::size_t i = 1; i < samples.size(); ++i)
        gap = std::max(gap, samples[i].time - samples[i - 1].time);
    return gap;
}

Result<void> check_flow(std::span<drivers::HeightSample const> samples)
{
    if (samples.size() < kMinReadings)
        return fail(Fault::Device,
                    fmt::format("only {} readings came in the time of a capture, expected at least "
                                "{}: check that the height sensor is connected and sends",
                                samples.size(), kMinReadings));
    if (auto const gap = longest_gap(samples); gap > kLongestCaptureGap)
        return fail(Fault::Device,
                    fmt::format("the height sensor was silent for {:.2f} s during the capture: "
                                "check its cable and capture again",
                                to_seconds(gap)));
    return {};
}

Result<void> check_rest(Statistics const& seen, std::span<drivers::HeightSample const> samples)
{
    auto const full_scale = samples.front().full_scale;
    if (is_on_rail(seen.on_low_rail, samples.size())
        || is_on_rail(seen.on_high_rail, samples.size()))
        return on_rail(seen, samples);
    if (double const moved = movement(seen);
        moved > allowed_movement(seen, samples.size(), full_scale))
        return fail(Fault::User,
                    fmt::format("the surface moved during the capture, by {:.1f} counts: let it "
                                "rest, then capture again",
                                moved));
    if (seen.noise > allowed_noise(full_scale))
        return fail(
            Fault::User,
            fmt::format("the reading jumps about by {:.1f} counts, expected at most {:.1f}: check "
                        "the wiper's wire and the ground, then capture again",
                        seen.noise, allowed_noise(full_scale)));
    return {};
}

std::vector<int> scatter_about(double mean, std::span<drivers::HeightSample const> samples)
{
    double const width = noise_bin_counts(samples.front().full_scale);
    std::vector<int> scatter(2 * kScatterReach + 1);
    int reach = 0;
    for (auto const& sample : samples) {
        double const bins = std::round((sample.counts - mean) / width);
        int const bin = static_cast<int>(
            std::clamp(bins, static_cast<double>(-kScatterReach), double { kScatterReach }));
        ++scatter[static_cast<std::size_t>(bin + kScatterReach)];
        reach = std::max(reach, std::abs(bin));
    }
    auto const spare = kScatterReach - reach;
    return { scatter.begin() + spare, scatter.end() - spare };
}

// Rounds to thousandths to keep files readable; a mean is far less accurate than that.
double to_thousandths(double counts)
{
    return std::round(counts * 1000) / 1000;
}

} // namespace

double noise_bin_counts(std::int32_t full_scale_counts)
{
    return std::max(1.0, std::round(full_scale_counts / 4095.0));
}

std::optional<HeightReading> summarize(std::span<drivers::HeightSample const> samples)
{
    if (samples.empty())
        return std::nullopt;
    auto const seen = statistics(samples);
    return HeightReading {
        .counts = seen.mean,
        .noise_counts = seen.deviation,
        .readings = samples.size(),
        .full_scale_counts = samples.front().full_scale,
        .is_on_rail = is_on_rail(seen.on_low_rail, samples.size())
            || is_on_rail(seen.on_high_rail, samples.size()),
        .is_at_rest = check_flow(samples) && check_rest(seen, samples),
    };
}

Result<HeightCapture> capture_at_rest(std::span<drivers::HeightSample const> samples,
                                      double ruler_mm)
{
    TRY(check_flow(samples));
    auto const seen = statistics(samples);
    TRY(check_rest(seen, samples));
    return HeightCapture {
        .ruler_mm = ruler_mm,
        .counts = to_thousandths(seen.mean),
        .noise_counts = to_thousandths(seen.deviation),
        .readings = samples.size(),
        .scatter = scatter_about(seen.mean, samples),
    };
}

void RecentReadings::add(drivers::HeightSample const& sample)
{
    // A changed full scale means another converter; times that go back mean another recording.
    if (!samples_.empty()
        && (samples_.back().full_scale != sample.full_scale || samples_.back().time > sample.time))
        samples_.clear();
    samples_.push_back(sample);
    while (sample.time - samples_.front().time > kCaptureTime)
        samples_.pop_front();
}

std::optional<HeightReading> RecentReadings::reading() const
{
    std::vector<drivers::HeightSample> const samples(samples_.begin(), samples_.end());
    return summarize(samples);
}

} // namespace tractus::calib
