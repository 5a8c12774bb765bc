#pragma once

#include "drivers/reports/report_source.h"
#include "engine/base/result.h"
#include "engine/base/time.h"
#include "sim/kernel_device.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace tractus::play {

// Actions of a device at times of its own while it is played to the kernel. Times are of the
// monotonic clock.
class DevicePart {
public:
    virtual ~DevicePart() = default;

    // The play begins now, or begins anew. Before, the device is there, and whatever it measures
    // stands still.
    virtual void begin(Timestamp now) = 0;

    // When it wants to be called next, before the begin as well; Timestamp::max() for never.
    virtual Timestamp due() const = 0;

    // Plays what is due; `now` is due() or later. Fails as the device does.
    virtual Result<void> play(Timestamp now) = 0;

    // Whether all that was to be played has been, `now`.
    virtual bool is_over(Timestamp now) const = 0;
};

// Gives reports one after another, and no value after the last one. Fails where they are read from
// a file that cannot be read.
using NextReport = std::function<Result<std::optional<drivers::RawReport>>()>;

// Sends reports when their times have come.
class ReportPart final : public DevicePart {
public:
    // `reports` begins to give them, from the first one; it is called at each begin. Their times
    // count from there. The device must outlive the part.
    ReportPart(sim::KernelDevice& device, std::function<NextReport()> reports);

    void begin(Timestamp now) override;
    Timestamp due() const override;
    Result<void> play(Timestamp now) override;
    bool is_over(Timestamp) const override { return read_ && !next_; }

private:
    Result<void> knock(Timestamp now);
    void rewind();
    void read_next();

    sim::KernelDevice& device_;
    std::function<NextReport()> reports_;
    NextReport next_report_;
    std::optional<drivers::RawReport> next_;
    Result<void> read_ {}; // Outcome of reading the next one.
    std::optional<Timestamp> begin_ {};
    Timestamp next_knock_ {};
};

// Everything that is played at once.
struct DevicePlay {
    std::vector<sim::KernelDevice*> devices {}; // Devices that are served, all of them.
    std::vector<DevicePart*> parts {};

    // Called when all devices are read for the first time; may be empty.
    std::function<void()> on_begin {};

    enum class Then {
        Leave,  // When the reports have been taken.
        Stay,   // Stays until asked to stop.
        Repeat, // Begins again, until asked to stop.
    };
    Then then = Then::Leave;
};

// Waits until some program reads each of the devices, then plays the parts to the end of them all;
// or until `stop` is set (by a signal handler, say). It sleeps whenever there is nothing to do.
// Fails as soon as a device or a part does.
Result<void> play_parts(DevicePlay const& play, std::atomic<bool> const& stop);

} // namespace tractus::play
