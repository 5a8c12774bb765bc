#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/pen_sample.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tractus::drivers {

// Properties of a pen device, known before its first report.
struct PenTraits {
    Vec2 size_mm = Vec2::Zero(); // Size of the active area.
    // True if the device does not report its size; see PenLayout::Size.
    bool is_size_assumed = false;
    bool has_pressure = false;
    bool has_tilt = false;
    // True if the reports can say that the pen has left. Otherwise a hovering pen counts as in
    // range until it has been silent for a while.
    bool has_in_range = false;
    bool has_eraser = false;
    unsigned button_count = 0; // Buttons on the pen's barrel.

    // Maxima of PenSample's raw_x, raw_y and raw_pressure.
    std::int32_t raw_x_maximum = 0;
    std::int32_t raw_y_maximum = 0;
    std::int32_t raw_pressure_maximum = 0;
};

// Decodes one pen device's reports, in order, into samples. A decoder keeps the pen's state, so
// each device and each replay needs a new one. It reads no clock: equal reports give equal samples.
//
// Regardless of what the device sends, the samples describe one tool at a time:
// - a touch implies in range, even if the device's in-range bit says otherwise;
// - the eraser end touches if the device reports "eraser", or both "invert" and "tip";
// - if the pen's other end arrives before the first has left, that report becomes the sample in
//   which the first end leaves, and the next report is the first sample of the new end;
// - a change to another pen is handled in the same way, if the pens have serial numbers;
// - a pen that leaves keeps its last position and tilt, whatever the last report contains, and
//   releases its buttons; after that there are no samples until it returns.
class PenDecoder {
public:
    virtual ~PenDecoder() = default;

    virtual PenTraits const& traits() const = 0;

    // Appends the report's samples to `out`, oldest first. There are none if the report is not
    // about a pen, or the pen is still out of range. There are several if the tablet collects
    // samples and sends them together, as Wacom's do over Bluetooth; their times lie between the
    // previous report and this one. Fails with a device error if the report is too short for
    // its fields or its id is not in the descriptor; then `out` is unchanged, the decoder stays
    // usable, and the report is ignored.
    virtual Result<void> decode(Timestamp received, std::span<std::byte const> report,
                                std::vector<PenSample>& out)
        = 0;

    Result<void> decode(RawReport const& report, std::vector<PenSample>& out)
    {
        return decode(report.received, report.bytes(), out);
    }

    // Time without samples after which the pen counts as gone, in the present state. It is needed
    // because some formats cannot report leaving, some streaming tablets stop without reporting it,
    // and some devices report it wrongly for a moment. No value if the device will report leaving
    // itself, or the pen is gone. A touching pen has a limit only if its tablet has been found to
    // stream (ReportRhythm): many tablets are silent about a pen that rests.
    //
    // The caller measures the time: see PenSilence.
    virtual std::optional<Duration> silence_limit() const = 0;

    // Handles a silence of silence_limit(): returns the sample in which the pen leaves, at its last
    // position. No value if it is already gone.
    virtual std::optional<PenSample> leave(Timestamp time) = 0;
};

// Measures the silence of one decoder's pen, by the times of the data in a replay, or by the clock
// with a live device.
class PenSilence {
public:
    // If the pen has been silent for too long at `now`, returns the sample in which it leaves, with
    // the time at which the limit was reached; otherwise no value. Call it with the time of each
    // report of any device before decoding that report and, with live devices, also whenever no
    // report is waiting.
    std::optional<PenSample> leave_after_silence(PenDecoder& pen, Timestamp now) const;

    // Notes that the decoder has returned a sample.
    void heard(PenSample const& sample) { last_ = sample.time; }

private:
    Timestamp last_ {};
};

} // namespace tractus::drivers
