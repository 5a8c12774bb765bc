#pragma once

#include "app/devices/live_devices.h"
#include "app/devices/live_recorder.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>

namespace tractus::devices {

struct LiveRecordingOptions {
    // Duration of the recording. No value: it lasts until `stop` is set.
    std::optional<double> seconds {};
    std::function<Timestamp()> now;
    std::function<void(Duration)> rest;
};

// Returns options that use the monotonic clock and really sleep.
LiveRecordingOptions live_recording_by_the_clock(std::optional<double> seconds);

struct LiveRecordingCounts {
    std::size_t reports = 0;
    // Number of reports lost because they arrived faster than they were written.
    std::uint64_t lost = 0;
};

// Records the devices' reports until the time is over, `stop` is set (by a signal handler, for
// example) or no device is left. Prints on standard error when a device disconnects or reconnects;
// the other devices are recorded meanwhile. Fails if the recorder's stream cannot be written.
Result<LiveRecordingCounts> record_live(LiveDevices& devices, LiveRecorder& recorder,
                                        LiveRecordingOptions const& options,
                                        std::atomic<bool> const& stop);

} // namespace tractus::devices
