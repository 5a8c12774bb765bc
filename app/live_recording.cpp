#include "app/live_recording.h"

#include "app/console.h"
#include "drivers/hid_source.h"
#include "drivers/log_writer.h"
#include "drivers/recording_source.h"
#include "drivers/threaded_source.h"

#include <chrono>
#include <fmt/core.h>
#include <memory>
#include <thread>

namespace tractus {

namespace {

constexpr auto kFlushEvery = std::chrono::milliseconds(250);
constexpr auto kRest = std::chrono::milliseconds(2);

Timestamp now()
{
    return Timestamp(std::chrono::steady_clock::now().time_since_epoch());
}

struct Recorded {
    ThreadedSource* threaded = nullptr;   // Owned by `source`.
    std::unique_ptr<ReportSource> source; // Null when the device has gone.
};

// Writes what waits. True if there was anything.
bool drain(Recorded& device, LiveRecordingCounts& counts)
{
    bool any = false;
    while (device.source) {
        auto const report = device.source->read(Duration::zero());
        if (!report) {
            print_error(
                fmt::format("{}: {}\n", device.source->info().name, report.error().message));
            counts.lost += device.threaded->lost_count();
            device.source.reset();
        } else if (!*report) {
            break;
        } else {
            ++counts.reports;
            any = true;
        }
    }
    return any;
}

} // namespace

Result<LiveRecordingCounts> record_live(std::ostream& out, std::vector<DeviceInfo> const& devices,
                                        LiveRecordingOptions const& options,
                                        std::atomic<bool> const& stop)
{
    auto const start = now();
    LogWriter log(out, { .devices = devices, .rig_text = options.rig_text, .start = start });
    std::vector<Recorded> recorded;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        auto opened = TRY(open_hid(devices[i]));
        auto threaded = TRY(ThreadedSource::start(std::move(opened)));
        auto* const observed = threaded.get();
        recorded.push_back({ observed, record_to(log, i, std::move(threaded)) });
    }

    LiveRecordingCounts counts;
    auto next_flush = start + kFlushEvery;
    bool any_device = true;
    while (!stop && any_device
           && (!options.seconds || to_seconds(now() - start) < *options.seconds)) {
        bool any_report = false;
        any_device = false;
        for (auto& device : recorded) {
            any_report |= drain(device, counts);
            any_device |= device.source != nullptr;
        }
        if (now() >= next_flush) {
            TRY(log.flush());
            next_flush = now() + kFlushEvery;
        }
        if (!any_report)
            std::this_thread::sleep_for(kRest);
    }
    for (auto& device : recorded)
        if (device.source)
            counts.lost += device.threaded->lost_count();
    TRY(log.flush());
    return counts;
}

} // namespace tractus
