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

// How long a loop over devices rests where none has sent anything new.
constexpr Duration kPollRest = std::chrono::milliseconds(2);

// A report of one of several devices.
struct LiveReport {
    std::size_t device = 0;       // Index in LiveDevices::infos().
    drivers::RawReport report {}; // Empty: the device went away.
};

// A device that could not be opened.
struct RefusedDevice {
    drivers::DeviceInfo info {};
    Error error {};
};

// Devices that send while the program runs: real ones, which may go away and come back, and logs
// that are played at their pace. Each is read on a thread of its own; this object belongs to one
// thread.
class LiveDevices {
public:
    enum class State {
        Connected,
        Away,  // It is looked for.
        Ended, // A log that is over.
    };

    // Sources at hand. Fails, as the station's fault, if the system gives no threads.
    static Result<LiveDevices> start(std::vector<std::unique_ptr<drivers::ReportSource>> sources);

    // Opens the real devices that can be opened; the others, and why, go into `refused`.
    static LiveDevices open_usable(std::vector<drivers::DeviceInfo> const& devices,
                                   std::vector<RefusedDevice>& refused);

    // Opens the devices and logs that people name: see device_name_help(). Fails, as the user's
    // fault, for a name that is neither, and as reading the log or opening the device does.
    static Result<LiveDevices> open_named(std::span<std::string const> names);

    // One more, to be read like the others. Fails like start().
    Result<void> add_source(std::unique_ptr<drivers::ReportSource> source)
    {
        return add(std::move(source), nullptr);
    }

    // One more that never waits: take() reads it, and no thread does. What it sends is in order
    // with the calls of take(), whatever the machine is busy with.
    void add_source_without_thread(std::unique_ptr<drivers::ReportSource> source);

    std::vector<drivers::DeviceInfo> const& infos() const { return infos_; }
    State state(std::size_t device) const;
    bool any_left() const; // False if all have ended.

    // Why a device that is away though it is plugged in cannot be opened; else empty.
    std::string refusal(std::size_t device) const;

    // A log as if its devices were there, played by another clock than this machine's; its
    // calibration is rig_text(). The same at each run: no thread reads it. Its tool lines count for
    // nothing: the pen that is played chooses the tools. Fails like read_log().
    static Result<LiveDevices> play_log(std::string const& name,
                                        std::function<Timestamp()> const& now);

    // The simulated rig, with a hand that draws our demonstration of every method on the plant that
    // hand_plant() names. It waits for begin_hand(), and chooses its tools. Fails like read_log(),
    // and where our own files are not found.
    static Result<LiveDevices> play_hand(std::function<Timestamp()> const& now);
    static std::string_view hand_plant() { return "birch"; }
    bool has_hand() const { return hand_.has_value(); }
    // See SimulatedHand; nothing without a hand.
    void begin_hand();
    std::vector<drivers::LogTool> take_hand_tools();

    // Puts what has come since the last call, in the order of its times, into `reports`. Times are
    // cut to microseconds, as logs have them: what is drawn live is what its recording draws.
    void take(std::vector<LiveReport>& reports);

    // Reports that came faster than they were taken, or are longer than a RawReport holds.
    std::uint64_t lost_count() const;

    // The calibration in the first log that was named and has one; empty if there is none.
    std::string const& rig_text() const { return rig_text_; }

private:
    struct Device {
        std::unique_ptr<drivers::ReportSource> source;     // Null when it has ended.
        drivers::ThreadedSource const* threaded = nullptr; // Null, too, if no thread reads it.
        drivers::ReconnectingSource const* reconnecting = nullptr; // Within source; null for a log.
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

// Describes what open_named() takes, for a command's help.
std::string_view device_name_help();

// The devices that are of use by themselves: every pen tablet and height sensor that can be found.
std::vector<drivers::DeviceInfo> find_pens_and_height_sensors();

} // namespace tractus::devices
