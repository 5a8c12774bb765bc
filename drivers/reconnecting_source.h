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

// Locations opened by the program's sources, so that a returning tablet is not confused with an
// identical one that is still open. Thread-safe.
class OpenLocations {
public:
    // Claims a location. Returns false if another source has it open.
    bool take(std::string const& location);
    void release(std::string const& location);

private:
    std::mutex mutex_;
    std::set<std::string> taken_;
};

// System functions for finding a lost device; tests can replace them.
struct Reconnection {
    std::function<std::vector<DeviceInfo>()> list;
    std::function<Result<std::unique_ptr<ReportSource>>(DeviceInfo)> open;
    std::function<Timestamp()> now; // Uses the same clock as the reports.

    // Total time that the machine has been suspended since boot.
    std::function<Duration()> slept;

    // Opens a listener for device events. If this is null, or returns null, there are no events and
    // the source only polls.
    std::function<std::unique_ptr<DeviceEvents>()> events {};

    // Polling interval without events, or while a present device cannot be opened yet. With events,
    // a longer interval is used as a fallback, since events can be lost.
    Duration retry_every = std::chrono::milliseconds(300);
    Duration retry_beside_events = std::chrono::seconds(5);

    // Shared by all sources of the program, which run on different threads.
    std::shared_ptr<OpenLocations> open_locations = std::make_shared<OpenLocations>();
};

// Returns the functions of the real system: list_device_addresses(), open_device() and
// listen_to_udev().
Reconnection system_reconnection();

// Returns the index in `found` of the device that was lost. It must have the same kind of address,
// ids, interface, serial number and report descriptor; of several such devices, the one at the same
// port is taken. If there is only one and it has no serial number, it may be at another port,
// because people change sockets.
std::optional<std::size_t> find_again(DeviceInfo const& lost, std::vector<DeviceInfo> const& found);

// A source for a device that can disappear and return. A device is lost when it is unplugged, or
// when the machine was suspended, because many tablets then forget their mode. read() then returns
// one empty report with the present time. From then on the device is searched for, after device
// events or every Reconnection::retry_every. Its reports continue once it is back, under any node.
// read() never fails.
//
// Used from one thread, except is_connected(), which any thread may call.
class ReconnectingSource final : public ReportSource {
public:
    // Opens the device at `info.location`. Fails like open_device().
    static Result<std::unique_ptr<ReconnectingSource>> open(DeviceInfo info,
                                                            Reconnection reconnection);
    ~ReconnectingSource() override;

    // Returns the description from the first opening, even if the device returns under another
    // address.
    DeviceInfo const& info() const override { return info_; }

    Result<std::optional<RawReport>> read(Duration timeout) override;

    // Number of oversized reports since the source was opened, including those before the device
    // was lost.
    std::uint64_t oversized_count() const override;

    bool is_connected() const { return is_connected_.load(std::memory_order_relaxed); }

    // Explains why the device, present again, cannot be opened; empty while it is absent or in use,
    // and during the first kPatience, in which udev may still be setting permissions. Thread-safe.
    std::string refusal() const;
    static constexpr Duration kPatience = std::chrono::seconds(2);

private:
    ReconnectingSource(DeviceInfo listed, Reconnection reconnection,
                       std::unique_ptr<ReportSource> source);

    RawReport lose();
    void refuse(std::string reason);
    void wait_for_device(Duration timeout);
    void search_for_device();
    void try_to_reopen();
    bool has_device_events() const;
    void try_to_open(DeviceInfo const& info);

    DeviceInfo listed_; // The device as it was listed; opening it can add information.
    Reconnection reconnection_;
    std::unique_ptr<ReportSource> source_; // Null while the device is away.
    DeviceInfo info_;
    std::string location_;                 // Location at which the device is open.
    std::unique_ptr<DeviceEvents> events_; // Set only while the device is away.
    Timestamp next_try_ {};
    Duration slept_ {};
    std::uint64_t too_long_before_ = 0;
    std::optional<Timestamp> refused_since_;
    std::atomic<bool> is_connected_ = true; // Written by the reading thread, read by any.
    mutable std::mutex refusal_mutex_;
    std::string refusal_; // Written by the reading thread, read by any, under its mutex.
};

} // namespace tractus::drivers
