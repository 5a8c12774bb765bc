#include "sim/simulated_height.h"

#include "engine/base/check.h"
#include "sim/random_streams.h"

#include <algorithm>
#include <cmath>

namespace tractus {

namespace {

constexpr int kReportId = 1;
constexpr std::size_t kReportSize = 4;

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
        0x01, // Generic desktop: multi-axis controller:
              // application
        0x85,
        kReportId, //
        0x09,
        0x36, // Slider
        0x15,
        0x00,
        0x27,
        low,
        high,
        0,
        0, // from 0 to full scale
        0x75,
        0x10,
        0x95,
        0x01,
        0x81,
        0x02, // 16 bits of input
        0x75,
        0x08,
        0x81,
        0x03, // a spare byte
        0xc0,
    };
    std::vector<std::byte> bytes;
    for (int const item : items)
        bytes.push_back(static_cast<std::byte>(item));
    return bytes;
}

RawReport encode(std::int32_t counts, Timestamp received)
{
    RawReport raw { .received = received, .size = kReportSize };
    raw.storage[0] = static_cast<std::byte>(kReportId);
    raw.storage[1] = static_cast<std::byte>(counts & 0xff);
    raw.storage[2] = static_cast<std::byte>(counts >> 8);
    return raw;
}

} // namespace

SimulatedDevice simulate_height(Hand const& hand, RigGeometry const& geometry,
                                HeightOptions const& options)
{
    SimulatedDevice device;
    device.info = {
        .name = "Simulated height sensor",
        .location = "simulated",
        .physical_path = "simulated/height",
        .bus = 6,
        .vendor_id = 0,
        .product_id = 2,
        .report_descriptor = report_descriptor(geometry.full_scale_counts),
    };
    DeviceClock clock(options.timing, { .seed = options.seed, .stream = kHeightTimingStream });
    HeightFaults faults(options.faults);
    Random noise({ .seed = options.seed, .stream = kHeightNoiseStream });
    for (auto now = clock.next_instant(); now < hand.end(); now = clock.next_instant()) {
        double const counts = ideal_counts(geometry, hand.at(now).position_mm.z())
            + options.noise_counts * noise.normal();
        double const read = std::clamp(std::round(counts), 0.0, double(geometry.full_scale_counts));
        auto const arrival = clock.arrival(now);
        if (auto const faulty
            = faults.apply(now, static_cast<std::int32_t>(read), geometry.full_scale_counts))
            device.reports.push_back(encode(*faulty, arrival));
    }
    return device;
}

} // namespace tractus
