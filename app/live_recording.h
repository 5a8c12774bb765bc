#pragma once

#include "drivers/device_info.h"
#include "engine/base/result.h"

#include <atomic>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace tractus {

struct LiveRecordingOptions {
    std::optional<double> seconds; // No value: until `stop` is set.
    std::string rig_text;          // The rig's calibration, to stand in the log; may be empty.
};

struct LiveRecordingCounts {
    std::size_t reports = 0;
    std::uint64_t lost = 0; // Reports that came faster than they were written.
};

// Records what devices send, as it comes, until the time is over, `stop` is set (by a signal
// handler, say) or no device is left. What has come is handed to the system every 250 ms, so that
// little is lost whatever happens. A device that goes away is named on standard error, and the
// others go on. Fails if a device cannot be opened or the stream cannot be written.
Result<LiveRecordingCounts> record_live(std::ostream& out, std::vector<DeviceInfo> const& devices,
                                        LiveRecordingOptions const& options,
                                        std::atomic<bool> const& stop);

} // namespace tractus
