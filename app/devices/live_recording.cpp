#include "app/devices/live_recording.h"

#include "app/devices/device_news.h"
#include "app/devices/live_devices.h"
#include "drivers/reports/clock.h"

#include <chrono>
#include <thread>
#include <vector>

namespace tractus::devices {

LiveRecordingOptions live_recording_by_the_clock(std::optional<double> seconds)
{
    return {
        .seconds = seconds,
        .now = drivers::monotonic_now,
        .rest = [](Duration duration) { std::this_thread::sleep_for(duration); },
    };
}

Result<LiveRecordingCounts> record_live(LiveDevices& devices, LiveRecorder& recorder,
                                        LiveRecordingOptions const& options,
                                        std::atomic<bool> const& stop)
{
    auto const start = options.now();
    std::vector<LiveReport> reports;
    DeviceNews news(devices);
    for (bool goes_on = true; goes_on;) {
        goes_on = !stop && devices.any_left()
            && (!options.seconds || to_seconds(options.now() - start) < *options.seconds);
        devices.take(reports);
        for (auto const& report : reports)
            recorder.write(report);
        TRY(recorder.flush_if_due(options.now()));
        news.tell(devices);
        if (reports.empty() && goes_on)
            options.rest(kPollRest);
    }
    TRY(recorder.flush());
    return LiveRecordingCounts { recorder.report_count(), devices.lost_count() };
}

} // namespace tractus::devices
