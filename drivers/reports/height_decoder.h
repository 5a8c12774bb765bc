#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/height_sample.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tractus::drivers {

// Counts of what came in a sensor's stream besides its samples, since the decoder was made. All 0
// for sensors that send no frames of their own.
struct HeightStreamCounts {
    std::uint64_t frames = 0;         // Whole ones.
    std::uint64_t lost_frames = 0;    // Their numbers are missing.
    std::uint64_t corrupt_frames = 0; // Their checksum is wrong, or their readings are impossible.
    std::uint64_t garbage_bytes = 0;  // Bytes between frames.
    std::uint64_t overruns = 0;       // Frames before which the sensor itself lost readings.
    std::uint64_t reference_faults = 0; // Frames of which the sensor says: supply or reference bad.
    std::uint64_t clock_restarts = 0;   // The sensor's clock began anew: unplugged or reset.
};

// Turns one height sensor's reports into samples, in order. Some decoders know the sensor's clock
// and what was lost, so each device needs its own, and each replay a new one. It reads no clock:
// the same reports give the same samples.
class HeightDecoder {
public:
    virtual ~HeightDecoder() = default;

    // The converter's greatest reading.
    virtual std::int32_t full_scale() const = 0;

    // Appends the report's samples to `out`, oldest first: none for a report that is not about the
    // height, several for a frame of several readings. Fails, as the device's fault, if something
    // in the report is broken; then too the samples that are good are in `out`, and the decoder
    // stays usable.
    virtual Result<void> decode(Timestamp received, std::span<std::byte const> report,
                                std::vector<HeightSample>& out)
        = 0;

    Result<void> decode(RawReport const& report, std::vector<HeightSample>& out)
    {
        return decode(report.received, report.bytes(), out);
    }

    virtual HeightStreamCounts stream_counts() const { return {}; }
};

} // namespace tractus::drivers
