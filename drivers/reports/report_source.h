#pragma once

#include "drivers/reports/device_info.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace tractus::drivers {

// One report, exactly as received, beginning with its report id if the device uses ids. A source
// drops reports that exceed `storage`.
//
// Size 0 means that the device was disconnected at that time, and anything in progress is over.
// Only a ReconnectingSource, or the log of one, returns this.
struct RawReport {
    Timestamp received {};
    std::size_t size = 0;
    std::array<std::byte, 512> storage {};

    std::span<std::byte const> bytes() const { return { storage.data(), size }; }
};

// A source of reports: a tablet, a height sensor, a simulated device, a log being replayed.
// Decoding is separate, so a log made from any source replays through the same decoder.
class ReportSource {
public:
    virtual ~ReportSource() = default;

    virtual DeviceInfo const& info() const = 0;

    // Waits at most `timeout` for the next report. Returns no value if none arrived in time. After
    // an error the source is unusable and must be destroyed. Called from one thread only.
    [[nodiscard]] virtual Result<std::optional<RawReport>> read(Duration timeout) = 0;

    // Number of reports so far that were dropped because they exceed a RawReport. Called from the
    // thread that reads.
    virtual std::uint64_t oversized_count() const { return 0; }
};

} // namespace tractus::drivers
