#pragma once

#include "calib/height_monitor.h"
#include "drivers/device_kind.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/pen_decoder.h"
#include "drivers/reports/report_source.h"
#include "engine/base/time.h"
#include "engine/base/vectors.h"

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

// Regularity of a device's reports, over the last second with reports.
struct ReportPace {
    double rate_hz = 0;        // Reports per second; 0 before the second report.
    Duration mean_interval {}; // Mean time between reports, without pauses (pen away).
    Duration jitter {};        // Standard deviation of the intervals.
    Duration longest_interval {};
};

// Statistics of the reports with one report id.
struct ReportIdReading {
    std::size_t reports = 0;
    std::size_t samples = 0; // Decoded pen samples.
    Timestamp first {};      // Time of the first report.
    Timestamp last {};       // Time of the last report.
};

// A touch of the pen from its first to its last sample. Positions are shares of the tablet's active
// area, so that a tablet's different report formats agree on them.
struct PenTouch {
    Timestamp begin {};
    Timestamp end {};
    Vec2 begin_place = Vec2::Zero();
    Vec2 end_place = Vec2::Zero();
};

// Pen statistics, used to judge the tip's switch.
struct PenReading {
    // Number of bins of the pressure histogram, 1 % each.
    static constexpr std::size_t kPressureSteps = 100;
    static constexpr std::size_t kMaxTouches = 200;

    std::size_t hovering = 0; // Number of samples in range but not touching.
    std::size_t touching = 0;
    // Histogram of the touching samples' pressure; empty if the device reports none.
    std::vector<std::size_t> pressures {};
    std::vector<PenTouch> touches {}; // The first kMaxTouches touches.
};

// Statistics of everything a device has sent so far.
struct DeviceReading {
    drivers::DeviceInfo info {};
    drivers::DeviceDescription description {};
    bool is_away = false; // The device disconnected and has not sent since.

    std::size_t reports = 0;
    std::size_t samples = 0; // Decoded samples of the pen or the height.
    std::size_t broken_reports = 0;
    std::string first_broken {};
    std::size_t departures = 0;
    std::size_t backward_times = 0; // Number of reports older than the one before.
    // Statistics by first byte (the report id, if the device uses ids).
    std::map<std::uint8_t, ReportIdReading> report_ids {};
    PenReading pen {};
    std::optional<Timestamp> last_sample {}; // Time of the newest sample.
    ReportPace pace {};

    std::optional<drivers::RawReport> last {};
    // The newest sample as names and values, such as ("x", "101.25 mm").
    std::vector<std::pair<std::string, std::string>> fields {};

    // Past and present faults of a height sensor, a sentence each.
    std::vector<std::string> height_faults {};
};

// Collects statistics from one device's reports, in order of arrival. Uses no clock, so that a log
// gives the same result as the live device.
class DeviceMonitor {
public:
    explicit DeviceMonitor(drivers::DeviceInfo const& info);

    void push(drivers::RawReport const& report);

    // Advances the time when no report has arrived.
    void pass_time(Timestamp now);

    DeviceReading reading() const;

private:
    void push_pen(drivers::RawReport const& report);
    void follow(drivers::PenSample const& sample);
    void push_height(drivers::RawReport const& report);
    void show(drivers::PenSample const& sample);
    void show(drivers::HeightSample const& sample);
    void count_broken(Error const& error);
    void watch_pace(Timestamp time);

    DeviceReading reading_;
    std::unique_ptr<drivers::PenDecoder> pen_;       // Null if the device is not a pen.
    std::unique_ptr<drivers::HeightDecoder> height_; // Null if the device is not a height sensor.
    std::optional<calib::HeightMonitor> height_monitor_;
    std::optional<Timestamp> begin_;
    std::vector<drivers::HeightSample> heights_; // Kept as a member so that its memory is reused.
    std::vector<drivers::PenSample> pens_;       // Kept as a member so that its memory is reused.
    bool was_touching_ = false;
    bool keeps_touch_ = false;     // True if the current touch is stored in PenReading::touches.
    std::deque<Timestamp> recent_; // Times of the last second's reports.
};

} // namespace tractus::diagnosis
