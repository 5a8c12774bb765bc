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

// Abilities of a pen device, known before its first report.
struct PenTraits {
    Vec2 size_mm = Vec2::Zero();  // Size of the active area.
    bool is_size_assumed = false; // The device does not tell its size; see PenLayout::Size.
    bool has_pressure = false;
    bool has_tilt = false;
    bool has_in_range = false; // If false, a hovering pen is in range until it is silent.
    bool has_eraser = false;
    unsigned button_count = 0; // Buttons on the pen's barrel.

    // The greatest values of PenSample's raw_x, raw_y and raw_pressure.
    std::int32_t raw_x_maximum = 0;
    std::int32_t raw_y_maximum = 0;
    std::int32_t raw_pressure_maximum = 0;
};

// Turns one pen device's reports into samples, in order. It knows the pen's state, so each device
// needs its own, and each replay a new one. It reads no clock: the same reports give the same
// samples.
//
// Whatever the device sends, the samples tell of one tool at a time:
// - a touch implies in range, even where the device's in-range bit says otherwise;
// - the eraser's end touches if the device says "eraser", or "invert" and "tip";
// - when the other end of the pen comes without the first having left, the report that says so
//   becomes the sample in which the first one leaves, and the next report is the new end's first;
// - the same when another pen comes, where pens have serial numbers;
// - a pen that leaves keeps its last position and tilt, whatever the last report has there, and
//   releases its buttons; after that nothing comes until it is back.
class PenDecoder {
public:
    virtual ~PenDecoder() = default;

    virtual PenTraits const& traits() const = 0;

    // Appends the report's samples to `out`, oldest first. None if the report says nothing of a
    // pen: one of the device's other reports, or out of range as before. Several where a tablet
    // collects what the pen did and sends it at once, as Wacom's do over Bluetooth; their times lie
    // between the report before and this one. Fails, as the device's fault, if the report is
    // shorter than its fields or not in the descriptor at all; then `out` is as it was, the decoder
    // stays usable, and the report counts as not sent.
    virtual Result<void> decode(Timestamp received, std::span<std::byte const> report,
                                std::vector<PenSample>& out)
        = 0;

    Result<void> decode(RawReport const& report, std::vector<PenSample>& out)
    {
        return decode(report.received, report.bytes(), out);
    }

    // How long after its last sample the pen has left if no other comes, as things are now: some
    // formats cannot say so, some tablets that stream stop without saying so, and some devices say
    // so wrongly for a moment. No value: the device will say so itself, or the pen is away. A pen
    // that touches has a limit only if its tablet has been found to stream (ReportRhythm): many
    // tablets are silent about a pen that rests.
    //
    // Whoever feeds the decoder keeps the time: see PenSilence.
    virtual std::optional<Duration> silence_limit() const = 0;

    // The pen has been silent for so long. The sample in which it leaves, where it was last; no
    // value if it is away already.
    virtual std::optional<PenSample> leave(Timestamp time) = 0;
};

// Keeps the time for one decoder: that of the data in a replay, that of the clock live.
class PenSilence {
public:
    // The sample in which the pen leaves if it has been silent for too long at `now`, with the time
    // at which that was so; else no value. Call it with the time of each report before decoding it,
    // of other devices' as well, and live when no report is waiting.
    std::optional<PenSample> leave_if_over(PenDecoder& pen, Timestamp now) const;

    // The decoder has given a sample.
    void heard(PenSample const& sample) { last_ = sample.time; }

private:
    Timestamp last_ {};
};

} // namespace tractus::drivers
