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

// Regularity of a device's reports, over the last second before its newest report.
struct ReportPace {
    double rate_hz = 0; // Reports per second; 0 before the second report.
    // Mean time between reports. Pauses, when the pen is away, do not count.
    Duration mean_interval {};
    Duration jitter {}; // Standard deviation of the times between reports.
    Duration longest_interval {};
};

// Statistics of a device's reports with a certain report id.
struct ReportIdReading {
    std::size_t reports = 0;
    std::size_t samples = 0; // Number of pen samples decoded from the reports.
    Timestamp first {};      // Time of the first report with this id.
    Timestamp last {};       // Time of the latest report with this id.
};

// A touch of the pen, from its first to its last sample. Positions are shares of the tablet's
// active area, so that they agree between a tablet's report formats.
struct PenTouch {
    Timestamp begin {};
    Timestamp end {};
    Vec2 begin_place = Vec2::Zero();
    Vec2 end_place = Vec2::Zero();
};

// Pen statistics, by which the switch in the pen's tip is judged.
struct PenReading {
    // Number of bins of the pressure histogram; each covers 1 % of the full pressure.
    static constexpr std::size_t kPressureSteps = 100;
    static constexpr std::size_t kMaxTouches = 200;

    std::size_t hovering = 0; // Number of samples with the pen in range but not touching.
    std::size_t touching = 0;
    // Number of touching samples in each bin of pressure; empty if the device reports no pressure.
    std::vector<std::size_t> pressures {};
    std::vector<PenTouch> touches {}; // The first kMaxTouches touches.
};

// Statistics of everything a device has sent so far.
struct DeviceReading {
    drivers::DeviceInfo info {};
    drivers::DeviceDescription description {};
    bool is_away = false; // True if the device disconnected and has not sent a report since.

    std::size_t reports = 0;
    std::size_t samples = 0; // Number of decoded samples of the pen or the height.
    std::size_t broken_reports = 0;
    std::string first_broken {};
    std::size_t departures = 0;
    // Number of reports with an earlier time than the preceding report.
    std::size_t backward_times = 0;
    // Statistics of reports by their first byte, which is the report id if the device uses ids.
    std::map<std::uint8_t, ReportIdReading> report_ids {};
    PenReading pen {};
    std::optional<Timestamp> last_sample {}; // Time of the newest sample.
    ReportPace pace {};

    std::optional<drivers::RawReport> last {};
    // Fields of the newest sample as names and values, such as ("x", "101.25 mm").
    std::vector<std::pair<std::string, std::string>> fields {};

    // Past and present faults of a height sensor, one sentence each.
    std::vector<std::string> height_faults {};
};

// Collects statistics of one device's reports, in order of arrival. It uses no clock, so that a log
// of the device gives the same result as the live device.
class DeviceMonitor {
public:
    explicit DeviceMonitor(drivers::DeviceInfo const& info);

    void push(drivers::RawReport const& report);

    // Tells the monitor the time while no report arrives.
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
    // Height samples of the current report. A member, so that its memory is reused.
    std::vector<drivers::HeightSample> heights_;
    // Pen samples of the current report. A member, so that its memory is reused.
    std::vector<drivers::PenSample> pens_;
    bool was_touching_ = false;
    // True if the current touch is one of the stored PenReading::touches.
    bool keeps_touch_ = false;
    std::deque<Timestamp> recent_; // Times of the reports received during the last second.
};

} // namespace tractus::diagnosis
