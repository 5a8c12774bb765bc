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

// A simulated device: its description, and all its reports in order of arrival. Times count from
// the hand's start.
struct SimulatedDevice {
    drivers::DeviceInfo info;
    std::vector<drivers::RawReport> reports;
};

// Delay and rate of a device's measurements.
struct DeviceTiming {
    Duration period {};  // Time between measurements.
    Duration latency {}; // Mean time from measurement to arrival.
    Duration jitter {};  // Standard deviation of the latency; arrivals never overtake each other.
};

// Generates the instants at which a device measures and the arrivals of its reports. The phase of
// the device's clock is random.
class DeviceClock {
public:
    DeviceClock(DeviceTiming const& timing, RandomKey const& key);

    // Returns the time of the next measurement.
    Timestamp next_instant();

    // Returns the arrival of the report about the measurement at `instant`.
    Timestamp arrival(Timestamp instant);

private:
    DeviceTiming timing_;
    Random random_;
    Timestamp next_ {};
    Timestamp last_arrival_ {};
};

// Waits until a simulated report's arrival time `due`, at most `timeout`, and returns whether that
// time has come. The simulation has no clock; callers who want reports in real time provide one.
using Pacer = std::function<bool(Timestamp due, Duration timeout)>;

// Opens the device as a source. Without a pacer, each read returns the next report at once,
// regardless of its time; with one, each report is returned when the pacer says that it is due.
// After the last report, read() returns no value: without a pacer at once, with one after its
// timeout, since the pacer is given a time that never comes. Reports keep their simulated times.
std::unique_ptr<drivers::ReportSource> open_simulated(SimulatedDevice device, Pacer pacer = {});

// A report of one of several devices.
struct ArrivedReport {
    std::size_t device = 0;
    drivers::RawReport const* report = nullptr;
};

// Returns the reports of all devices in the order in which they arrive at one computer, as a log of
// them contains them. The result points into `devices`. At equal times, the earlier device comes
// first.
std::vector<ArrivedReport> in_order_of_arrival(std::span<SimulatedDevice const* const> devices);

} // namespace tractus::sim
