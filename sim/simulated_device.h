#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/report_source.h"
#include "engine/base/random.h"
#include "engine/base/time.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace tractus::sim {

// A device that is not there: what it is, and everything it sends, in order of arrival. Times count
// from the hand's start.
struct SimulatedDevice {
    drivers::DeviceInfo info;
    std::vector<drivers::RawReport> reports;
};

// How a device's measurements become arrivals.
struct DeviceTiming {
    Duration period {};  // Time between measurements.
    Duration latency {}; // Mean time from measurement to arrival.
    Duration jitter {};  // Standard deviation of the latency; arrivals never overtake each other.
};

// The instants at which a device measures, and when each measurement arrives. Which phase the
// device's own clock has is random.
class DeviceClock {
public:
    DeviceClock(DeviceTiming const& timing, RandomKey const& key);

    // When the next measurement is taken.
    Timestamp next_instant();

    // When the report about the measurement at `instant` arrives.
    Timestamp arrival(Timestamp instant);

private:
    DeviceTiming timing_;
    Random random_;
    Timestamp next_ {};
    Timestamp last_arrival_ {};
};

// Waits until a simulated report's arrival time `due`, at most `timeout`, and says whether that
// time has come. Sim knows no clock: whoever wants reports to come as they would from a device
// brings one.
using Pacer = std::function<bool(Timestamp due, Duration timeout)>;

// The device as a source. Without a pacer each read gives the next report at once, whatever its
// time; with one, each report comes when the pacer says that it is due. After the last report
// nothing comes any more: without a pacer read() returns no value at once, with one it waits out
// its timeout, since the pacer is given a time that never comes. Reports keep their simulated
// times.
std::unique_ptr<drivers::ReportSource> open_simulated(SimulatedDevice device, Pacer pacer = {});

// A report of one of several devices.
struct ArrivedReport {
    std::size_t device = 0;
    drivers::RawReport const* report = nullptr;
};

// The reports of all devices as they arrive at one computer: what a log of them holds. Points into
// `devices`. At the same time the earlier device is first.
std::vector<ArrivedReport> in_order_of_arrival(std::span<SimulatedDevice const* const> devices);

} // namespace tractus::sim
