#include "sim/simulated_height.h"

#include "drivers/height_decoders.h"
#include "engine/base/check.h"
#include "sim/height_sensor_frames.h"
#include "sim/random_streams.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace tractus::sim {

namespace {

constexpr int kHeightReportId = 1;

std::vector<std::byte> report_descriptor(std::int32_t full_scale_counts)
{
    CHECK(full_scale_counts > 0 && full_scale_counts <= 65535);
    int const low = full_scale_counts & 0xff;
    int const high = full_scale_counts >> 8;
    int const items[] = {
        0x05,
        0x01,
        0x09,
        0x08,
        0xa1,
        0x01, // Generic Desktop: multi-axis controller, application collection.
        0x85,
        kHeightReportId, //
        0x09,
        0x36, // Usage Slider.
        0x15,
        0x00,
        0x27,
        low,
        high,
        0,
        0, // Logical range from 0 to full scale.
        0x75,
        0x10,
        0x95,
        0x01,
        0x81,
        0x02, // Input of 16 bits.
        0x75,
        0x08,
        0x81,
        0x03, // A padding byte.
        0xc0,
    };
    std::vector<std::byte> bytes;
    for (int const item : items)
        bytes.push_back(static_cast<std::byte>(item));
    return bytes;
}

} // namespace

drivers::DeviceInfo simulated_slider_info(std::int32_t full_scale_counts)
{
    return {
        .name = "Simulated height sensor",
        .location = "simulated",
        .physical_path = "simulated/height",
        .bus = 6,
        .vendor_id = 0,
        .product_id = 2,
        .report_descriptor = report_descriptor(full_scale_counts),
    };
}

drivers::RawReport simulated_slider_report(std::int32_t counts, Timestamp received)
{
    drivers::RawReport report { .received = received, .size = 4 };
    report.storage[0] = static_cast<std::byte>(kHeightReportId);
    report.storage[1] = static_cast<std::byte>(counts & 0xff);
    report.storage[2] = static_cast<std::byte>(counts >> 8);
    return report;
}

namespace {

// Encodes the sensor's readings as its reports.
class Encoder {
public:
    virtual ~Encoder() = default;
    virtual drivers::DeviceInfo info() const = 0;

    // Adds a reading and returns the report that it completes, if any. No value of `counts` means
    // that the sensor fails at this time.
    virtual std::optional<std::vector<std::byte>> encode(Timestamp instant,
                                                         std::optional<std::int32_t> counts)
        = 0;
};

class SliderEncoder final : public Encoder {
public:
    explicit SliderEncoder(std::int32_t full_scale_counts)
        : full_scale_counts_(full_scale_counts)
    {
    }

    drivers::DeviceInfo info() const override { return simulated_slider_info(full_scale_counts_); }

    std::optional<std::vector<std::byte>> encode(Timestamp,
                                                 std::optional<std::int32_t> counts) override
    {
        if (!counts)
            return std::nullopt;
        auto const report = simulated_slider_report(*counts, {});
        return std::vector(report.bytes().begin(), report.bytes().end());
    }

private:
    std::int32_t full_scale_counts_;
};

class FrameEncoder final : public Encoder {
public:
    FrameEncoder(std::int32_t full_scale_counts, HeightOptions const& options)
        : model_(HeightSensorModel::Options {
            .full_scale = static_cast<std::uint16_t>(full_scale_counts),
            .period_us
            = static_cast<std::uint16_t>(options.timing.period / std::chrono::microseconds(1)),
            .samples_per_frame = static_cast<std::uint8_t>(options.samples_per_frame) })
        , clock_rate_(1 / (1 + options.clock_drift_ppm * 1e-6))
    {
        bool const is_on
            = model_.accept({ .request_type = drivers::kVendorInterfaceOut,
                              .request = std::uint8_t(drivers::HeightSensorRequest::SetStreaming),
                              .value = 1 },
                            {});
        CHECK(is_on);
    }

    drivers::DeviceInfo info() const override { return model_.info(); }

    std::optional<std::vector<std::byte>> encode(Timestamp instant,
                                                 std::optional<std::int32_t> counts) override
    {
        // The clock starts near the end of its range, so that it wraps soon.
        constexpr std::uint32_t kFirstUs = 0xFFFF'FFFF - 2'000'000;
        auto const since_us = std::llround(to_seconds(instant) * 1e6 * clock_rate_);
        if (counts)
            return model_.push(kFirstUs + static_cast<std::uint32_t>(since_us),
                               static_cast<std::uint16_t>(*counts));
        model_.lose_frames(0); // The unfinished frame would have a gap, so it is dropped.
        return std::nullopt;
    }

private:
    HeightSensorModel model_;
    double clock_rate_; // Rate of the sensor's clock relative to true time.
};

std::unique_ptr<Encoder> make_encoder(std::int32_t full_scale_counts, HeightOptions const& options)
{
    if (options.wire == HeightWire::Frames)
        return std::make_unique<FrameEncoder>(full_scale_counts, options);
    return std::make_unique<SliderEncoder>(full_scale_counts);
}

// Returns the mean latency of the decoded samples. For frames it depends on the decoder's clock
// map, which follows the least latency instead of the mean.
Duration mean_latency(SimulatedDevice const& device, std::vector<Timestamp> const& instants)
{
    auto const decoder = drivers::make_height_decoder(device.info);
    CHECK(decoder);
    std::vector<drivers::HeightSample> samples;
    for (auto const& report : device.reports)
        CHECK((*decoder)->decode(report, samples));
    CHECK(samples.size() == instants.size());
    Duration sum {};
    for (std::size_t i = 0; i < samples.size(); ++i)
        sum += samples[i].time - instants[i];
    return samples.empty() ? Duration() : sum / static_cast<std::int64_t>(samples.size());
}

} // namespace

SimulatedHeight simulate_height(Hand const& hand, RigGeometry const& geometry,
                                HeightOptions const& options)
{
    auto const encoder = make_encoder(geometry.full_scale_counts, options);
    SimulatedDevice device { .info = encoder->info(), .reports = {} };
    DeviceClock clock(options.timing, { .seed = options.seed, .stream = kHeightTimingStream });
    HeightFaults faults(options.faults);
    Random noise({ .seed = options.seed, .stream = kHeightNoiseStream });
    // Times of the readings in complete reports, followed by those for the next report.
    std::vector<Timestamp> instants;
    std::size_t sent = 0;
    for (auto now = clock.next_instant(); now < hand.end(); now = clock.next_instant()) {
        double const counts = ideal_counts(geometry, hand.at(now).position_mm.z())
            + options.noise_counts * noise.normal();
        double const read = std::clamp(std::round(counts), 0.0, double(geometry.full_scale_counts));
        auto const reading
            = faults.apply(now, static_cast<std::int32_t>(read), geometry.full_scale_counts);
        auto const bytes = encoder->encode(now, reading);
        auto const arrival = clock.arrival(now);
        instants.push_back(now);
        if (!reading)
            instants.resize(sent);
        if (!bytes)
            continue;
        sent = instants.size();
        drivers::RawReport report { .received = arrival, .size = bytes->size() };
        std::ranges::copy(*bytes, report.storage.begin());
        device.reports.push_back(report);
    }
    instants.resize(sent);
    auto const latency = options.wire == HeightWire::Frames ? mean_latency(device, instants)
                                                            : options.timing.latency;
    return { .device = std::move(device), .latency = latency };
}

} // namespace tractus::sim
