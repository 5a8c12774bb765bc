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

// How regularly reports come, over the last second of them.
struct ReportPace {
    double rate_hz = 0;        // 0 until there are two reports.
    Duration mean_interval {}; // Mean time between reports; pauses (the pen is away) do not count.
    Duration jitter {};        // Standard deviation of the intervals.
    Duration longest_interval {};
};

// What a device sent under one report id.
struct ReportIdReading {
    std::size_t reports = 0;
    std::size_t samples = 0; // Samples of a pen.
    Timestamp first {};      // Time of the first report …
    Timestamp last {};       // … and of the last.
};

// A touch of the pen, from its first sample to its last. Places are shares of the tablet's active
// area, so that two formats of one tablet agree on them.
struct PenTouch {
    Timestamp begin {};
    Timestamp end {};
    Vec2 begin_place = Vec2::Zero();
    Vec2 end_place = Vec2::Zero();
};

// What a pen did, for judging its tip.
struct PenReading {
    static constexpr std::size_t kPressureSteps = 100; // Of 1 %.
    static constexpr std::size_t kMostTouches = 200;

    std::size_t hovering = 0; // Samples in range that do not touch.
    std::size_t touching = 0;
    // Touching samples by pressure; empty where the device tells none.
    std::vector<std::size_t> pressures {};
    std::vector<PenTouch> touches {}; // The first kMostTouches of them.
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
    // By first byte (the report id, if the device uses ids).
    std::map<std::uint8_t, ReportIdReading> report_ids {};
    PenReading pen {};
    std::optional<Timestamp> last_sample {}; // Time of the newest sample.
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
    void follow(drivers::PenSample const& sample);
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
    bool was_touching_ = false;
    bool keeps_touch_ = false;     // Whether the touch under way is among PenReading::touches.
    std::deque<Timestamp> recent_; // Times of the last second's reports.
};

} // namespace tractus::diagnosis
