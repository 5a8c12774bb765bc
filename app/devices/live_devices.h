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

// Sleep of a loop over devices when none has sent anything new.
constexpr Duration kPollRest = std::chrono::milliseconds(2);

// A report of one of several devices.
struct LiveReport {
    std::size_t device = 0;       // Index in LiveDevices::infos().
    drivers::RawReport report {}; // The report; empty: the device disconnected.
};

// A device that could not be opened, and why.
struct RefusedDevice {
    drivers::DeviceInfo info {};
    Error error {};
};

// Devices that send while the program runs: real ones, which may disconnect and reconnect, and logs
// played in real time. Each is read on a thread of its own; this object belongs to one thread.
class LiveDevices {
public:
    enum class State {
        Connected,
        Away,  // Disconnected; the program keeps looking for it.
        Ended, // The device was a log, which has ended.
    };

    // Starts with existing sources. Fails with an internal error if no thread can be started.
    static Result<LiveDevices> start(std::vector<std::unique_ptr<drivers::ReportSource>> sources);

    // Opens those real devices that can be opened; the others go into `refused` with the reason.
    static LiveDevices open_usable(std::vector<drivers::DeviceInfo> const& devices,
                                   std::vector<RefusedDevice>& refused);

    // Opens devices and logs by the names that users give (device_name_help()). Fails with a user
    // error for a name that is neither, and like opening the device or reading the log.
    static Result<LiveDevices> open_named(std::span<std::string const> names);

    // Adds a source, which is read like the others. Fails like start().
    Result<void> add_source(std::unique_ptr<drivers::ReportSource> source)
    {
        return add(std::move(source), nullptr);
    }

    // Adds a source that never waits. It is read by take() instead of a thread, so that the order
    // of its reports does not depend on the machine's load.
    void add_source_without_thread(std::unique_ptr<drivers::ReportSource> source);

    std::vector<drivers::DeviceInfo> const& infos() const { return infos_; }
    State state(std::size_t device) const;
    bool any_left() const; // False if all devices have ended.

    // Reason why a connected device cannot be opened; empty if there is none.
    std::string refusal(std::size_t device) const;

    // Plays a log as if its devices were connected, on the clock `now`. Its calibration is
    // rig_text(). Deterministic, as no thread reads it. Tool lines are ignored: the played pen
    // selects tools in the window. Fails like read_log().
    static Result<LiveDevices> play_log(std::string const& name,
                                        std::function<Timestamp()> const& now);

    // Plays the simulated rig, whose hand draws the demonstration of all methods on the plant
    // hand_plant(). It waits for start_simulated_hand() and selects its own tools. Fails like
    // read_log(), and if the program's own files are missing.
    static Result<LiveDevices> play_hand(std::function<Timestamp()> const& now);
    static std::string_view hand_plant() { return "birch"; }
    bool has_hand() const { return hand_.has_value(); }
    // Start the simulated hand, and return its due tool lines (SimulatedHand). No effect without a
    // hand.
    void start_simulated_hand();
    std::vector<drivers::LogTool> take_hand_tools();

    // Replaces `reports` by everything that arrived since the last call, in order of time. Times
    // are truncated to microseconds, as in logs, so that a recording reproduces the live drawing
    // exactly.
    void take(std::vector<LiveReport>& reports);

    // Number of reports lost because they came faster than they were taken, or were longer than a
    // RawReport can hold.
    std::uint64_t lost_count() const;

    // Calibration of the first named log that has one; empty if there is none.
    std::string const& rig_text() const { return rig_text_; }

private:
    struct Device {
        std::unique_ptr<drivers::ReportSource> source; // Source of the device; null after its end.
        // Part of `source` that runs a thread; null if ended or if no thread reads it.
        drivers::ThreadedSource const* threaded = nullptr;
        // Part of `source` that reconnects; null for a log.
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

// Describes the names that open_named() accepts, for a command's help.
std::string_view device_name_help();

// All connected pen tablets and height sensors, which need no further configuration.
std::vector<drivers::DeviceInfo> find_pens_and_height_sensors();

} // namespace tractus::devices
