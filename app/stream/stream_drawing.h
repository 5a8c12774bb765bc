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

// Streams a log, at `speed` times real time or, without a speed, as fast as readers follow. With a
// socket, streaming begins when the first reader connects. Without a speed no lines are dropped, as
// the log waits for slow readers; only readers that fetch nothing at all for LineServer::kPatience
// lose tip lines. With a speed, all slow readers lose tip lines. `pace` provides the clock. Ends
// after the last report, or without an end line when `stop` is set. Fails if the log cannot be read
// to its end or the output cannot be written.
Result<void> stream_log(station::LogReplay& replay, StreamOutput& output,
                        std::optional<double> speed, std::atomic<bool> const& stop,
                        play::Pace pace = play::pace_from_now({}));

// Streams what the user draws until the time is over, `stop` is set or no device is left; an
// unfinished stroke then ends. Prints on standard error when a device disconnects or reconnects.
// Streaming does not wait for readers of a socket, except for up to a second at the end. Fails if
// the output cannot be written.
Result<void> stream_live(devices::LiveDevices& devices, station::Station& station,
                         StreamOutput& output, devices::LiveRecordingOptions const& options,
                         std::atomic<bool> const& stop);

} // namespace tractus::stream
