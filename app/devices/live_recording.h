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
    std::optional<double> seconds {}; // Duration of the recording; no value: until `stop` is set.
    std::function<Timestamp()> now;
    std::function<void(Duration)> rest;
};

// Options with the monotonic clock and real sleeping.
LiveRecordingOptions live_recording_by_the_clock(std::optional<double> seconds);

struct LiveRecordingCounts {
    std::size_t reports = 0;
    // Number of reports lost because they came faster than they were written.
    std::uint64_t lost = 0;
};

// Records what devices send until the time is over, `stop` is set (by a signal handler, for
// example) or no device is left. Disconnects and reconnects are printed on standard error; the
// other devices continue. Fails if the recorder's stream cannot be written.
Result<LiveRecordingCounts> record_live(LiveDevices& devices, LiveRecorder& recorder,
                                        LiveRecordingOptions const& options,
                                        std::atomic<bool> const& stop);

} // namespace tractus::devices
