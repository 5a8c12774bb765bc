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

// Streams what a log amounts to, at `speed` times the pace of the hand, or without it as fast as it
// is read. A socket is waited at until somebody reads, and without a speed nothing is left out for
// readers that are slow: the log waits for them, but not for those that take nothing at all
// (LineServer::kPatience), which lose tips as they do at a speed. `pace` gives the clock. Ends when
// everything is read, or with `stop`, of which nothing more is said. Fails if the log cannot be
// read to its end, or the output cannot be written.
Result<void> stream_log(station::LogReplay& replay, StreamOutput& output,
                        std::optional<double> speed, std::atomic<bool> const& stop,
                        play::Pace pace = play::pace_from_now({}));

// Streams what a person draws, until the time is over, `stop` is set or no device is left; the
// stroke under way ends then. What goes away and comes back is named on standard error. No reader
// of a socket is waited for, but for a second at the end. Fails if the output cannot be written.
Result<void> stream_live(devices::LiveDevices& devices, station::Station& station,
                         StreamOutput& output, devices::LiveRecordingOptions const& options,
                         std::atomic<bool> const& stop);

} // namespace tractus::stream
