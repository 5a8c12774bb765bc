#include "drivers/reconnecting_source.h"

#include "drivers/device_list.h"
#include "drivers/reports/device_address.h"
#include "engine/base/check.h"

#include <algorithm>
#include <ctime>
#include <thread>
#include <utility>

namespace tractus::drivers {

using namespace std::chrono_literals;

bool OpenLocations::take(std::string const& location)
{
    std::lock_guard const lock(mutex_);
    return taken_.insert(location).second;
}

void OpenLocations::release(std::string const& location)
{
    std::lock_guard const lock(mutex_);
    taken_.erase(location);
}

static Duration clock_time(clockid_t clock)
{
    timespec time {};
    ::clock_gettime(clock, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

Reconnection system_reconnection()
{
    return {
        .list = list_device_addresses,
        .open = open_device,
        .now = [] { return Timestamp(clock_time(CLOCK_MONOTONIC)); },
        // CLOCK_BOOTTIME includes suspended time, CLOCK_MONOTONIC does not.
        .slept = [] { return clock_time(CLOCK_BOOTTIME) - clock_time(CLOCK_MONOTONIC); },
        .events = listen_to_udev,
    };
}

// True if both addresses use the kernel's driver, or both bypass it. A device that returns must be
// opened in the same way as before.
static bool are_reached_alike(DeviceInfo const& a, DeviceInfo const& b)
{
    auto const first = parse_device_address(a.location);
    auto const second = parse_device_address(b.location);
    return first && second && first->index() == second->index();
}

static bool is_of_the_same_kind(DeviceInfo const& a, DeviceInfo const& b)
{
    return are_reached_alike(a, b) && a.bus == b.bus && a.vendor_id == b.vendor_id
        && a.product_id == b.product_id && a.interface_number == b.interface_number
        && a.serial_number == b.serial_number && a.report_descriptor == b.report_descriptor;
}

std::optional<std::size_t> find_again(DeviceInfo const& lost, std::vector<DeviceInfo> const& found)
{
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!is_of_the_same_kind(lost, found[i]))
            continue;
        if (!lost.physical_path.empty() && found[i].physical_path == lost.physical_path)
            return i;
        candidates.push_back(i);
    }
    bool const is_unique = candidates.size() == 1 || !lost.serial_number.empty();
    return !candidates.empty() && is_unique ? std::optional(candidates.front()) : std::nullopt;
}

Result<std::unique_ptr<ReconnectingSource>> ReconnectingSource::open(DeviceInfo info,
                                                                     Reconnection reconnection)
{
    CHECK(reconnection.list && reconnection.open && reconnection.now && reconnection.slept);
    auto source = TRY(reconnection.open(info));
    return std::unique_ptr<ReconnectingSource>(
        new ReconnectingSource(std::move(info), std::move(reconnection), std::move(source)));
}

ReconnectingSource::ReconnectingSource(DeviceInfo listed, Reconnection reconnection,
                                       std::unique_ptr<ReportSource> source)
    : listed_(std::move(listed))
    , reconnection_(std::move(reconnection))
    , source_(std::move(source))
    , info_(source_->info())
    , location_(listed_.location)
    , slept_(reconnection_.slept())
{
    reconnection_.open_locations->take(location_);
}

ReconnectingSource::~ReconnectingSource()
{
    if (source_)
        reconnection_.open_locations->release(location_);
}

std::uint64_t ReconnectingSource::oversized_count() const
{
    return too_long_before_ + (source_ ? source_->oversized_count() : 0);
}

std::string ReconnectingSource::refusal() const
{
    std::lock_guard const lock(refusal_mutex_);
    return refusal_;
}

// Records why the device cannot be opened; an empty reason clears the record.
void ReconnectingSource::refuse(std::string reason)
{
    if (reason.empty()) {
        refused_since_.reset();
    } else {
        auto const now = reconnection_.now();
        refused_since_ = refused_since_.value_or(now);
        if (now - *refused_since_ < kPatience)
            return;
    }
    std::lock_guard const lock(refusal_mutex_);
    refusal_ = std::move(reason);
}

RawReport ReconnectingSource::lose()
{
    too_long_before_ += source_->oversized_count();
    source_.reset();
    refuse({});
    reconnection_.open_locations->release(location_);
    is_connected_.store(false, std::memory_order_relaxed);
    // Listens for events before the first search, so that no event is missed in between.
    if (reconnection_.events)
        events_ = reconnection_.events();
    next_try_ = reconnection_.now();
    return { .received = next_try_ };
}

Result<std::optional<RawReport>> ReconnectingSource::read(Duration timeout)
{
    if (source_) {
        // Tolerance in the comparison, because the two clocks are not read at the same instant.
        constexpr Duration kSleep = 500ms;
        auto const slept = reconnection_.slept();
        if (std::exchange(slept_, slept) + kSleep < slept)
            return std::optional(lose());
        auto report = source_->read(timeout);
        return report ? std::move(report) : std::optional(lose());
    }
    wait_for_device(timeout);
    return std::optional<RawReport>();
}

void ReconnectingSource::wait_for_device(Duration timeout)
{
    auto const wait = std::max(next_try_ - reconnection_.now(), Duration::zero());
    auto const rest = std::min(wait, timeout);
    bool has_come = false;
    if (events_)
        has_come = events_->wait(rest);
    else
        std::this_thread::sleep_for(rest);
    if (has_come || wait <= timeout)
        search_for_device();
}

// True if an event will announce the device. No event announces a change of permissions of a device
// that is present but could not be opened.
bool ReconnectingSource::has_device_events() const
{
    auto const address = parse_device_address(listed_.location);
    return events_ && !refused_since_ && address && !needs_explicit_name(*address);
}

void ReconnectingSource::search_for_device()
{
    next_try_ = reconnection_.now();
    try_to_reopen();
    next_try_
        += has_device_events() ? reconnection_.retry_beside_events : reconnection_.retry_every;
}

void ReconnectingSource::try_to_reopen()
{
    auto found = reconnection_.list();
    std::erase_if(found, [this](DeviceInfo const& info) {
        bool const is_free = reconnection_.open_locations->take(info.location);
        if (is_free)
            reconnection_.open_locations->release(info.location);
        return !is_free;
    });
    if (auto const index = find_again(listed_, found)) {
        try_to_open(found[*index]);
        return;
    }
    refuse({}); // The device is not present.
    // A device that cannot be listed is tried at its previous address.
    auto const address = parse_device_address(listed_.location);
    if (address && needs_explicit_name(*address))
        try_to_open(listed_);
}

void ReconnectingSource::try_to_open(DeviceInfo const& info)
{
    if (!reconnection_.open_locations->take(info.location))
        return;
    auto wanted = info;
    wanted.settings = info_.settings;
    auto opened = reconnection_.open(std::move(wanted));
    if (!opened) {
        reconnection_.open_locations->release(info.location);
        refuse(opened.error().message);
        return;
    }
    refuse({});
    events_.reset();
    source_ = *std::move(opened);
    location_ = info.location;
    slept_ = reconnection_.slept();
    is_connected_.store(true, std::memory_order_relaxed);
}

} // namespace tractus::drivers
