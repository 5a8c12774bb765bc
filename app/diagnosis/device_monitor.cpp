#include "app/diagnosis/device_monitor.h"
#include "drivers/height_decoders.h"
#include "drivers/tablets/pen_decoders.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <numbers>
#include <numeric>

namespace tractus::diagnosis {

using namespace std::chrono_literals;

static constexpr Duration kWindow = 1s;
// A longer time between reports is a pause, in which the pen was away; pauses do not count as
// intervals.
static constexpr Duration kPause = 100ms;

DeviceMonitor::DeviceMonitor(drivers::DeviceInfo const& info)
{
    reading_.info = info;
    reading_.description = drivers::describe_device(info);
    if (auto pen = drivers::make_pen_decoder(info))
        pen_ = *std::move(pen);
    else if (auto height = drivers::make_height_decoder(info))
        height_ = *std::move(height);
    if (height_) {
        // Without a calibration, jumps of the height cannot be detected; other faults can.
        calib::Rig rig;
        rig.full_scale_counts = height_->full_scale();
        height_monitor_.emplace(rig);
    }
}

void DeviceMonitor::push(drivers::RawReport const& report)
{
    if (report.size == 0) {
        ++reading_.departures;
        reading_.is_away = true;
        if (height_monitor_)
            height_monitor_->restart_after_reconnection();
        if (auto const gone = pen_ ? pen_->leave(report.received) : std::nullopt)
            show(*gone);
        return;
    }
    if (!begin_)
        begin_ = report.received;
    reading_.is_away = false;
    ++reading_.reports;
    auto& of_id = reading_.report_ids[std::to_integer<std::uint8_t>(report.storage[0])];
    if (of_id.reports++ == 0)
        of_id.first = report.received;
    of_id.last = report.received;
    watch_pace(report.received);
    reading_.last = report;
    auto const samples_before = reading_.samples;
    if (pen_)
        push_pen(report);
    else if (height_)
        push_height(report);
    of_id.samples += reading_.samples - samples_before;
    if (reading_.samples != samples_before)
        reading_.last_sample = report.received;
}

void DeviceMonitor::push_pen(drivers::RawReport const& report)
{
    pens_.clear();
    if (auto const decoded = pen_->decode(report, pens_); !decoded)
        count_broken(decoded.error());
    reading_.samples += pens_.size();
    for (auto const& sample : pens_) {
        follow(sample);
        show(sample);
    }
}

void DeviceMonitor::follow(drivers::PenSample const& sample)
{
    auto& pen = reading_.pen;
    bool const begins = sample.touching && !was_touching_;
    was_touching_ = sample.touching;
    if (!sample.touching) {
        pen.hovering += sample.in_range;
        return;
    }
    ++pen.touching;
    if (sample.pressure) {
        pen.pressures.resize(PenReading::kPressureSteps);
        auto const step = static_cast<std::size_t>(*sample.pressure * PenReading::kPressureSteps);
        ++pen.pressures[std::min(step, PenReading::kPressureSteps - 1)];
    }
    Vec2 const place = sample.position_mm.cwiseQuotient(pen_->traits().size_mm);
    if (begins) {
        keeps_touch_ = pen.touches.size() < PenReading::kMaxTouches;
        if (keeps_touch_)
            pen.touches.push_back({ .begin = sample.time, .begin_place = place });
    }
    if (keeps_touch_) {
        pen.touches.back().end = sample.time;
        pen.touches.back().end_place = place;
    }
}

void DeviceMonitor::push_height(drivers::RawReport const& report)
{
    heights_.clear();
    if (auto const decoded = height_->decode(report, heights_); !decoded)
        count_broken(decoded.error());
    reading_.samples += heights_.size();
    for (auto const& sample : heights_)
        height_monitor_->push(sample);
    if (!heights_.empty())
        show(heights_.back());
}

void DeviceMonitor::pass_time(Timestamp now)
{
    while (!recent_.empty() && recent_.front() + kWindow < now)
        recent_.pop_front();
    if (!begin_)
        begin_ = now;
    if (height_monitor_)
        height_monitor_->advance(now);
}

void DeviceMonitor::count_broken(Error const& error)
{
    if (reading_.broken_reports++ == 0)
        reading_.first_broken = error.message;
}

void DeviceMonitor::watch_pace(Timestamp time)
{
    if (!recent_.empty() && time < recent_.back()) {
        ++reading_.backward_times;
        recent_.clear();
    }
    // Maximum number of reports kept from the last second; USB allows 8,000 per second.
    constexpr std::size_t kMaxPerSecond = 20'000;
    recent_.push_back(time);
    while (recent_.front() + kWindow < time || recent_.size() > kMaxPerSecond)
        recent_.pop_front();
}

static std::string yes(bool value)
{
    return value ? "yes" : "no";
}

void DeviceMonitor::show(drivers::PenSample const& sample)
{
    auto& fields = reading_.fields;
    fields = { { "x", fmt::format("{:.2f} mm", sample.position_mm.x()) },
               { "y", fmt::format("{:.2f} mm", sample.position_mm.y()) } };
    if (sample.pressure)
        fields.emplace_back("pressure", fmt::format("{:.3f}", *sample.pressure));
    if (sample.tilt_rad) {
        Vec2 const tilt_deg = *sample.tilt_rad * (180 / std::numbers::pi);
        fields.emplace_back("tilt", fmt::format("{:+.1f} {:+.1f} deg", tilt_deg.x(), tilt_deg.y()));
    }
    fields.emplace_back("in range", yes(sample.in_range));
    fields.emplace_back("touching", yes(sample.touching));
    fields.emplace_back("end", sample.eraser ? "eraser" : "tip");
    fields.emplace_back("buttons", fmt::format("{:#05b}", sample.buttons));
    fields.emplace_back("counts",
                        fmt::format("{} {} {}", sample.raw_x, sample.raw_y, sample.raw_pressure));
}

void DeviceMonitor::show(drivers::HeightSample const& sample)
{
    reading_.fields
        = { { "height", fmt::format("{} of {} counts", sample.counts, sample.full_scale) },
            { "share", fmt::format("{:.2f} %", 100.0 * sample.counts / sample.full_scale) } };
}

static ReportPace pace_of(std::deque<Timestamp> const& times)
{
    std::vector<double> intervals_s;
    for (std::size_t i = 1; i < times.size(); ++i)
        if (auto const interval = times[i] - times[i - 1]; interval <= kPause)
            intervals_s.push_back(to_seconds(interval));
    if (intervals_s.empty())
        return {};
    auto const count = static_cast<double>(intervals_s.size());
    double const mean_s = std::accumulate(intervals_s.begin(), intervals_s.end(), 0.0) / count;
    double squares = 0;
    for (double const interval_s : intervals_s)
        squares += (interval_s - mean_s) * (interval_s - mean_s);
    return { .rate_hz = mean_s > 0 ? 1 / mean_s : 0,
             .mean_interval = from_seconds(mean_s),
             .jitter = from_seconds(std::sqrt(squares / count)),
             .longest_interval
             = from_seconds(*std::max_element(intervals_s.begin(), intervals_s.end())) };
}

DeviceReading DeviceMonitor::reading() const
{
    auto reading = reading_;
    reading.pace = pace_of(recent_);
    if (height_monitor_)
        reading.height_faults
            = calib::describe_faults(*height_monitor_, begin_.value_or(Timestamp {}));
    return reading;
}

} // namespace tractus::diagnosis
