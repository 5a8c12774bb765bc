#include "app/devices/live_recording.h"

#include "app/terminal/console.h"
#include "drivers/clock.h"

#include <chrono>
#include <fmt/core.h>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tractus {

static constexpr auto kRest = std::chrono::milliseconds(2);

static char const* describe(LiveDevices::State state)
{
    switch (state) {
    case LiveDevices::State::Connected:
        return "is back";
    case LiveDevices::State::Away:
        return "has gone: waiting for it to come back";
    case LiveDevices::State::Ended:
        return "is over";
    }
    return "";
}

// What has been said of a device.
struct Told {
    LiveDevices::State state = LiveDevices::State::Connected;
    std::string refusal {};
};

// Says on standard error what has changed.
static void tell_changes(LiveDevices const& devices, std::vector<Told>& told)
{
    for (std::size_t i = 0; i < told.size(); ++i) {
        auto const state = devices.state(i);
        auto const refusal = devices.refusal(i);
        if (std::exchange(told[i].state, state) != state)
            print_error(fmt::format("{} at {} {}\n", devices.infos()[i].name,
                                    devices.infos()[i].location, describe(state)));
        if (std::exchange(told[i].refusal, refusal) != refusal && !refusal.empty())
            print_error(fmt::format("it is plugged in again, but {}\n", refusal));
    }
}

LiveRecordingOptions live_recording_by_the_clock(std::optional<double> seconds)
{
    return {
        .seconds = seconds,
        .now = monotonic_now,
        .rest = [](Duration duration) { std::this_thread::sleep_for(duration); },
    };
}

Result<LiveRecordingCounts> record_live(LiveDevices& devices, LiveRecorder& recorder,
                                        LiveRecordingOptions const& options,
                                        std::atomic<bool> const& stop)
{
    auto const start = options.now();
    std::vector<LiveReport> reports;
    std::vector<Told> told(devices.infos().size());
    for (bool goes_on = true; goes_on;) {
        goes_on = !stop && devices.any_left()
            && (!options.seconds || to_seconds(options.now() - start) < *options.seconds);
        devices.take(reports);
        for (auto const& report : reports)
            recorder.write(report);
        TRY(recorder.flush_if_due(options.now()));
        tell_changes(devices, told);
        if (reports.empty() && goes_on)
            options.rest(kRest);
    }
    TRY(recorder.flush());
    return LiveRecordingCounts { recorder.report_count(), devices.lost_count() };
}

} // namespace tractus
