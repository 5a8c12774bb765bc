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

// Timed behaviour of an emulated kernel device. Times are of the monotonic clock.
class DevicePart {
public:
    virtual ~DevicePart() = default;

    // Starts or restarts playing. Before the first call the device exists and its measurements are
    // constant.
    virtual void begin(Timestamp now) = 0;

    // Time of the next call of play(), also before the start; Timestamp::max() for never.
    virtual Timestamp due() const = 0;

    // Plays everything that is due; `now` is due() or later. Fails like the device.
    virtual Result<void> play(Timestamp now) = 0;

    // True if everything has been played at time `now`.
    virtual bool is_over(Timestamp now) const = 0;
};

// Returns the next report, or no value after the last one. Fails if its file cannot be read.
using NextReport = std::function<Result<std::optional<drivers::RawReport>>()>;

// Sends reports at their times.
class ReportPart final : public DevicePart {
public:
    // `reports` creates a function that returns the reports from the first one on; it is called at
    // each start, from which their times count. The device must outlive the part.
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
    Result<void> read_ {}; // Outcome of reading the next report.
    std::optional<Timestamp> begin_ {};
    Timestamp next_knock_ {};
};

// All devices and parts that are played together.
struct PlaybackSet {
    std::vector<sim::KernelDevice*> devices {}; // All devices to serve.
    std::vector<DevicePart*> parts {};

    // Called when all devices have a reader for the first time; may be empty.
    std::function<void()> on_begin {};

    enum class Then {
        Leave,  // Ends when the reports have been fetched.
        Stay,   // Continues to exist until asked to stop.
        Repeat, // Starts over until asked to stop.
    };
    Then then = Then::Leave;
};

// Waits until each device has a reader, then plays all parts to their ends, or until `stop` is set
// (by a signal handler, for example). Sleeps while there is nothing to do. Fails as soon as a
// device or a part does.
Result<void> play_parts(PlaybackSet const& play, std::atomic<bool> const& stop);

} // namespace tractus::play
