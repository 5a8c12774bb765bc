#pragma once

#include "app/play/simulated_hand.h"
#include "drivers/links/threaded_source.h"
#include "drivers/reconnecting_source.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tractus::devices {

// Time for which a loop over devices sleeps if no device has sent anything new.
constexpr Duration kPollRest = std::chrono::milliseconds(2);

// A report, and the device that sent it.
struct LiveReport {
    std::size_t device = 0;       // Index in LiveDevices::infos().
    drivers::RawReport report {}; // An empty report means that the device disconnected.
};

// A device that could not be opened, and the reason.
struct RefusedDevice {
    drivers::DeviceInfo info {};
    Error error {};
};

// Devices that send reports while the program runs: real devices, which may disconnect and
// reconnect, and logs played in real time. Each device is read on a thread of its own. Use this
// object from one thread.
class LiveDevices {
public:
    enum class State {
        Connected,
        Away,  // Disconnected; the program keeps trying to reconnect.
        Ended, // The log that played the device has ended.
    };

    // Starts reading the given sources. Fails with an internal error if no thread can be started.
    static Result<LiveDevices> start(std::vector<std::unique_ptr<drivers::ReportSource>> sources);

    // Opens those real devices that can be opened. The others are added to `refused`, with the
    // reason.
    static LiveDevices open_usable(std::vector<drivers::DeviceInfo> const& devices,
                                   std::vector<RefusedDevice>& refused);

    // Opens devices and logs by names as described by device_name_help(). Fails with a user error
    // for a name that is neither a device's nor a log's, if a device cannot be opened, and if a log
    // cannot be read.
    static Result<LiveDevices> open_named(std::span<std::string const> names);

    // Adds a source, which gets a thread of its own. Fails like start().
    Result<void> add_source(std::unique_ptr<drivers::ReportSource> source)
    {
        return add(std::move(source), nullptr);
    }

    // Adds a source that never blocks. It is read by take() instead of a thread, so that the order
    // of its reports does not depend on the machine's load.
    void add_source_without_thread(std::unique_ptr<drivers::ReportSource> source);

    std::vector<drivers::DeviceInfo> const& infos() const { return infos_; }
    State state(std::size_t device) const;
    bool any_left() const; // False if all devices have ended.

    // Returns the reason why a connected device cannot be opened, or an empty text if there is
    // none.
    std::string refusal(std::size_t device) const;

    // Plays a log on the clock `now` as if its devices were connected. rig_text() returns the log's
    // calibration. The playback is deterministic, as no thread reads the log. The log's tool lines
    // are ignored: the played pen selects tools in the window. Fails like read_log().
    static Result<LiveDevices> play_log(std::string const& name,
                                        std::function<Timestamp()> const& now);

    // Plays the simulated rig, whose simulated hand draws one of the program's recordings, such as
    // "demo/tour.tractus-log". Without a name, that is the demonstration of all methods on the
    // plant hand_plant(). The hand waits for start_simulated_hand() and selects its own tools.
    // Fails like read_log(), and if the program's own files are missing.
    static Result<LiveDevices> play_hand(std::function<Timestamp()> const& now,
                                         std::string const& recording = "demo/station.tractus-log");
    static std::string_view hand_plant() { return "birch"; }
    bool has_hand() const { return hand_.has_value(); }
    // start_simulated_hand() lets the simulated hand begin; take_hand_tools() returns its tool
    // lines that have become due (SimulatedHand). Both do nothing without a simulated hand.
    void start_simulated_hand();
    // True once a simulated hand has drawn all of its recording.
    bool is_hand_over() const { return hand_ && hand_->is_over(); }
    std::vector<drivers::LogTool> take_hand_tools();

    // Replaces `reports` by all reports received since the last call, in order of time. Times are
    // truncated to microseconds, as in logs, so that a recording reproduces the live drawing
    // exactly.
    void take(std::vector<LiveReport>& reports);

    // Number of reports lost because they arrived faster than they were taken, or were longer than
    // a RawReport can hold.
    std::uint64_t lost_count() const;

    // Calibration of the first of the named logs that contains one; empty if none does.
    std::string const& rig_text() const { return rig_text_; }

private:
    struct Device {
        std::unique_ptr<drivers::ReportSource> source; // Null once the source has ended.
        // Part of `source` that runs a thread; null if `source` has ended or is read without a
        // thread.
        drivers::ThreadedSource const* threaded = nullptr;
        // Part of `source` that reconnects; null if the device is played from a log.
        drivers::ReconnectingSource const* reconnecting = nullptr;
    };

    Result<void> add(std::unique_ptr<drivers::ReportSource> source,
                     drivers::ReconnectingSource const* reconnecting);
    Result<void> add_real(drivers::DeviceInfo info, drivers::Reconnection const& reconnection);
    Result<void> add_log(std::string const& name);

    std::vector<drivers::DeviceInfo> infos_;
    std::vector<Device> devices_;
    std::uint64_t lost_by_ended_ = 0;
    std::string rig_text_;
    std::optional<play::SimulatedHand> hand_ {};
};

// Describes the names that open_named() accepts, for a command's help text.
std::string_view device_name_help();

// Returns all connected pen tablets and those height sensors that need no configuration.
std::vector<drivers::DeviceInfo> find_pens_and_height_sensors();

} // namespace tractus::devices
