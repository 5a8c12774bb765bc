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

// Statistics of a sensor's stream since its decoder was made. All 0 for sensors that do not send
// numbered frames.
struct HeightStreamCounts {
    std::uint64_t frames = 0;         // Complete frames received.
    std::uint64_t lost_frames = 0;    // Frames whose sequence numbers were skipped.
    std::uint64_t corrupt_frames = 0; // Frames with a wrong checksum or impossible readings.
    std::uint64_t garbage_bytes = 0;  // Bytes between frames.
    // Frames for which the sensor reports that it lost earlier readings.
    std::uint64_t overruns = 0;
    // Frames for which the sensor reports a bad supply or reference.
    std::uint64_t reference_faults = 0;
    // Restarts of the sensor's clock, after unplugging or a reset.
    std::uint64_t clock_restarts = 0;
};

// Decodes one height sensor's reports, in order, into samples. Some decoders keep state about the
// sensor's clock and lost frames, so each device and each replay needs a new one. A decoder reads
// no clock: equal reports give equal samples.
class HeightDecoder {
public:
    virtual ~HeightDecoder() = default;

    // The greatest reading of the sensor's converter.
    virtual std::int32_t full_scale() const = 0;

    // Appends the report's samples to `out`, oldest first: none for a report that is not about the
    // height, several for a frame with several readings. Fails with a device error if part of
    // the report is broken; its valid samples are appended even then, and the decoder stays usable.
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
