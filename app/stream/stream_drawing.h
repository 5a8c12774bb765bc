#pragma once

#include "app/devices/live_devices.h"
#include "app/devices/live_recording.h"
#include "app/play/paced_log.h"
#include "app/station/log_replay.h"
#include "app/station/station.h"
#include "app/stream/stream_output.h"
#include "engine/base/result.h"

#include <atomic>
#include <optional>

namespace tractus::stream {

// Streams a log, at `speed` times real time or as fast as possible. With a socket it waits for the
// first reader. Without a speed no lines are dropped, as the log waits for slow readers; but
// readers that fetch nothing at all (LineServer::kPatience) lose tips, as slow readers do at a
// given speed. `pace` provides the clock. Ends after the last report, or silently when `stop` is
// set. Fails if the log cannot be read to its end or the output cannot be written.
Result<void> stream_log(station::LogReplay& replay, StreamOutput& output,
                        std::optional<double> speed, std::atomic<bool> const& stop,
                        play::Pace pace = play::pace_from_now({}));

// Streams what the user draws until the time is over, `stop` is set or no device is left; an
// unfinished stroke ends then. Disconnects and reconnects are printed on standard error. Readers of
// a socket are not waited for, except for a second at the end. Fails if the output cannot be
// written.
Result<void> stream_live(devices::LiveDevices& devices, station::Station& station,
                         StreamOutput& output, devices::LiveRecordingOptions const& options,
                         std::atomic<bool> const& stop);

} // namespace tractus::stream
