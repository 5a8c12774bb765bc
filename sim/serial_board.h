#pragma once

#include "engine/base/result.h"
#include "engine/base/time.h"
#include "sim/height_curve.h"
#include "sim/kernel_device.h"

#include <cstdint>
#include <optional>

namespace tractus::sim {

// A board on a serial line that prints the heights of a recording, as the sketch of
// firmware-notes/serial.md does: a line for each reading, whether or not anybody listens. It reads
// no clock; the caller gives all times.
class SerialBoard {
public:
    struct Options {
        double rate_hz = 400;
        // Number that is printed at the full scale of the recorded sensor; no value: that full
        // scale itself.
        std::optional<std::int32_t> full_scale {};
    };

    // The port must outlive the board.
    SerialBoard(KernelDevice& port, HeightCurve heights, Options const& options);

    std::int32_t full_scale() const { return full_scale_; }

    // Starts or restarts the recording. Before that, the board prints the recording's first height.
    void begin(Timestamp now) { begin_ = now; }

    // Time of the next line.
    Timestamp due() const { return next_line_; }

    // Prints all lines that are due until `now`. After a pause of more than a second, the lines of
    // the pause are skipped. Fails like the port.
    Result<void> play(Timestamp now);

    // True if the recording has been played to its end.
    bool is_over(Timestamp now) const;

private:
    Result<void> print_line();

    KernelDevice& port_;
    HeightCurve heights_;
    Duration period_;
    std::int32_t full_scale_;
    std::optional<Timestamp> begin_ {};
    // Time of the next line; Timestamp::min() before the first line.
    Timestamp next_line_ = Timestamp::min();
};

} // namespace tractus::sim
