#pragma once

#include "drivers/links/device_events.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace tractus::drivers {

// The locations that a program's sources have open, so that of two equal tablets the one that comes
// back is not taken for the one that never left. Safe to use from any thread.
class OpenLocations {
public:
    // False if somebody else has it.
    bool take(std::string const& location);
    void release(std::string const& location);

private:
    std::mutex mutex_;
    std::set<std::string> taken_;
};

// How a lost device is looked for: the system's means, or those of a test.
struct Reconnection {
    std::function<std::vector<DeviceInfo>()> list;
    std::function<Result<std::unique_ptr<ReportSource>>(DeviceInfo)> open;
    std::function<Timestamp()> now; // The clock of the reports.

    // How long the machine has slept since it was started.
    std::function<Duration()> slept;

    // Tells that it is worth looking. Null, or gives null: nobody does.
    std::function<std::unique_ptr<DeviceEvents>()> events {};

    // How often to look where no events tell of the device, and where it is there but cannot be
    // opened yet; and how often nevertheless, since events may be lost.
    Duration retry_every = std::chrono::milliseconds(300);
    Duration retry_beside_events = std::chrono::seconds(5);

    // Shared by all sources of the program, each on a thread of its own.
    std::shared_ptr<OpenLocations> open_locations = std::make_shared<OpenLocations>();
};

// The system's means (list_device_addresses, open_device, listen_to_udev).
Reconnection system_reconnection();

// Returns which of these devices, if any, is the one that was lost: same kind of address, ids,
// interface, serial number and report descriptor; of several, the one at the same place of the bus.
// Without a serial number a single candidate may stand at another place, since people use another
// socket.
std::optional<std::size_t> find_again(DeviceInfo const& lost, std::vector<DeviceInfo> const& found);

// A device that may go away and come back. When it is lost, by unplugging or because the machine
// slept (many tablets forget their mode then), an empty report says so, once, with the time. From
// then on it is looked for, when devices have come or after Reconnection::retry_every, and its
// reports go on when it is there again, whatever its node is called then. read() never fails: there
// is always hope.
//
// Called from one thread; is_connected() from any.
class ReconnectingSource final : public ReportSource {
public:
    // Opens the device at `info.location`. Fails as opening does.
    static Result<std::unique_ptr<ReconnectingSource>> open(DeviceInfo info,
                                                            Reconnection reconnection);
    ~ReconnectingSource() override;

    // Describes the device as it was first opened, whatever it is called when it comes back.
    DeviceInfo const& info() const override { return info_; }

    Result<std::optional<RawReport>> read(Duration timeout) override;

    // Counts those of the device before it went away, too.
    std::uint64_t too_long_count() const override;

    bool is_connected() const { return is_connected_.load(std::memory_order_relaxed); }

    // Why the device, which is there again, cannot be opened; empty while it is away or in use.
    // Said only after kPatience: at first udev is still at work. From any thread.
    std::string refusal() const;
    static constexpr Duration kPatience = std::chrono::seconds(2);

private:
    ReconnectingSource(DeviceInfo listed, Reconnection reconnection,
                       std::unique_ptr<ReportSource> source);

    RawReport lose();
    void refuse(std::string reason);
    void wait_for_it(Duration timeout);
    void look_for_it();
    void try_to_find_it();
    bool is_told_of_it() const;
    void try_to_open(DeviceInfo const& info);

    DeviceInfo listed_; // The device as it was found; opening may tell more of it.
    Reconnection reconnection_;
    std::unique_ptr<ReportSource> source_; // Null while the device is away.
    DeviceInfo info_;
    std::string location_;                 // Where it is open.
    std::unique_ptr<DeviceEvents> events_; // While the device is away.
    Timestamp next_try_ {};
    Duration slept_ {};
    std::uint64_t too_long_before_ = 0;
    std::optional<Timestamp> refused_since_;
    std::atomic<bool> is_connected_ = true; // Reading thread to any.
    mutable std::mutex refusal_mutex_;
    std::string refusal_; // Reading thread to any, under its mutex.
};

} // namespace tractus::drivers
