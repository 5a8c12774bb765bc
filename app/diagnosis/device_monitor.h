#pragma once

#include "calib/height_monitor.h"
#include "drivers/device_kind.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/pen_decoder.h"
#include "drivers/reports/report_source.h"
#include "engine/base/time.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tractus::diagnosis {

// How regularly reports come, over the last second of them.
struct ReportPace {
    double rate_hz = 0;        // 0 until there are two reports.
    Duration mean_interval {}; // Mean time between reports; pauses (the pen is away) do not count.
    Duration jitter {};        // Standard deviation of the intervals.
    Duration longest_interval {};
};

// Facts about what one device has sent so far, and what became of it.
struct DeviceReading {
    drivers::DeviceInfo info {};
    drivers::DeviceDescription description {};
    bool is_away = false; // It went away and has not sent since.

    std::size_t reports = 0;
    std::size_t samples = 0; // Samples of the pen or of the height.
    std::size_t broken_reports = 0;
    std::string first_broken {};
    std::size_t departures = 0;
    std::size_t backward_times = 0; // Reports older than the one before.
    // How many reports there were of each first byte (the report id, if the device uses ids).
    std::map<std::uint8_t, std::size_t> first_bytes {};
    ReportPace pace {};

    std::optional<drivers::RawReport> last {};
    // The newest sample as names and values: ("x", "101.25 mm").
    std::vector<std::pair<std::string, std::string>> fields {};

    // Faults that a height sensor has or had, a sentence each.
    std::vector<std::string> height_faults {};
};

// Follows one device's reports, in the order in which they come. Knows no clock: a log gives what
// the live device gave.
class DeviceMonitor {
public:
    explicit DeviceMonitor(drivers::DeviceInfo const& info);

    void push(drivers::RawReport const& report);

    // Time has passed without a report.
    void pass_time(Timestamp now);

    DeviceReading reading() const;

private:
    void push_pen(drivers::RawReport const& report);
    void push_height(drivers::RawReport const& report);
    void show(drivers::PenSample const& sample);
    void show(drivers::HeightSample const& sample);
    void count_broken(Error const& error);
    void watch_pace(Timestamp time);

    DeviceReading reading_;
    std::unique_ptr<drivers::PenDecoder> pen_;       // Null if it is none.
    std::unique_ptr<drivers::HeightDecoder> height_; // Null if it is none.
    std::optional<calib::HeightMonitor> height_monitor_;
    std::optional<Timestamp> begin_;
    std::vector<drivers::HeightSample> heights_; // Kept for its memory.
    std::vector<drivers::PenSample> pens_;       // Likewise.
    std::deque<Timestamp> recent_;               // Times of the last second's reports.
};

} // namespace tractus::diagnosis
