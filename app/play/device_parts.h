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

// Behaviour of an emulated kernel device over time. All times are of the monotonic clock.
class DevicePart {
public:
    virtual ~DevicePart() = default;

    // Starts playing, or starts again. Before the first call the device exists and its measurements
    // are constant.
    virtual void begin(Timestamp now) = 0;

    // Time at which play() must be called next, also before begin(); Timestamp::max() for never.
    virtual Timestamp due() const = 0;

    // Plays everything that is due. `now` must not be earlier than due(). Fails if the device does.
    virtual Result<void> play(Timestamp now) = 0;

    // True if there is nothing left to play at the time `now`.
    virtual bool is_over(Timestamp now) const = 0;
};

// A function that returns the next report, or no value after the last one. It fails if the file
// with the reports cannot be read.
using NextReport = std::function<Result<std::optional<drivers::RawReport>>()>;

// Sends the reports of an emulated device at their times.
class ReportPart final : public DevicePart {
public:
    // `reports` is called whenever playing starts. It creates a function that returns the reports,
    // beginning with the first one; their times count from the start. The device must outlive the
    // part.
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
    Result<void> read_ {}; // Success, or the error in reading the next report.
    std::optional<Timestamp> begin_ {};
    Timestamp next_knock_ {};
};

// All emulated devices and parts that are played together.
struct PlaybackSet {
    std::vector<sim::KernelDevice*> devices {}; // All devices whose requests are served.
    std::vector<DevicePart*> parts {};

    // Called once, when every device has a reader; may be empty.
    std::function<void()> on_begin {};

    enum class Then {
        Leave,  // Playing ends once readers have fetched the reports.
        Stay,   // The devices continue to exist until asked to stop.
        Repeat, // Playing starts again, until asked to stop.
    };
    Then then = Then::Leave;
};

// Waits until each device has a reader, then plays all parts to their ends, or until `stop` is set
// (by a signal handler, for example). Sleeps while there is nothing to do. Fails as soon as a
// device or a part fails.
Result<void> play_parts(PlaybackSet const& play, std::atomic<bool> const& stop);

} // namespace tractus::play
