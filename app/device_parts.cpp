#include "app/device_parts.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fmt/core.h>
#include <poll.h>
#include <utility>

namespace tractus {

namespace {

constexpr Duration kKnockEvery = std::chrono::milliseconds(10);
constexpr Duration kLongestSleep = std::chrono::milliseconds(50); // Until `stop` is looked at.
constexpr Duration kFarewell = std::chrono::milliseconds(200);    // For what has not been taken.

Timestamp clock_now()
{
    return Timestamp(std::chrono::steady_clock::now().time_since_epoch());
}

// Sleeps until a device's file is ready, at most `timeout`, and serves the devices.
Result<void> serve_devices(std::vector<KernelDevice*> const& devices, Duration timeout)
{
    std::vector<pollfd> files;
    for (auto const* const device : devices)
        device->add_files_to(files);
    auto const wait_ns = std::clamp(timeout, Duration::zero(), kLongestSleep).count();
    timespec const wait { .tv_sec = 0, .tv_nsec = wait_ns };
    if (::ppoll(files.data(), files.size(), &wait, nullptr) < 0 && errno != EINTR)
        return fail(Fault::Station,
                    fmt::format("cannot wait for devices: {}", std::strerror(errno)));
    for (auto* const device : devices)
        TRY(device->serve());
    return {};
}

// Plays what is due, then sleeps until something is, or the kernel asks something.
Result<void> take_step(DevicePlay const& play)
{
    auto next_due = Timestamp::max();
    for (auto* const part : play.parts) {
        if (auto const now = clock_now(); part->due() <= now)
            TRY(part->play(now));
        next_due = std::min(next_due, part->due());
    }
    bool const is_never = next_due == Timestamp::max();
    return serve_devices(play.devices, is_never ? kLongestSleep : next_due - clock_now());
}

bool are_read(DevicePlay const& play)
{
    return std::all_of(play.devices.begin(), play.devices.end(),
                       [](KernelDevice const* device) { return device->is_read(); });
}

bool are_over(DevicePlay const& play)
{
    return std::all_of(play.parts.begin(), play.parts.end(),
                       [](DevicePart const* part) { return part->is_over(); });
}

} // namespace

ReportPart::ReportPart(KernelDevice& device, std::vector<RawReport> reports)
    : device_(device)
    , reports_(std::move(reports))
{
    CHECK(!reports_.empty());
}

void ReportPart::begin(Timestamp now)
{
    begin_ = now;
    has_begun_ = true;
    next_ = device_.tells_readers_by_reports() ? 1 : 0; // See knock().
}

Timestamp ReportPart::due() const
{
    if (!has_begun_)
        return device_.tells_readers_by_reports() ? next_knock_ : Timestamp::max();
    return is_over() ? Timestamp::max() : begin_ + reports_[next_].received.time_since_epoch();
}

Result<void> ReportPart::play(Timestamp now)
{
    if (!has_begun_)
        return knock(now);
    for (; due() <= now; ++next_)
        TRY(device_.send(reports_[next_].bytes()));
    return {};
}

// Some devices learn that they are read from a report's being taken: the first one waits for that.
// While there is no host it is lost, and sent again.
Result<void> ReportPart::knock(Timestamp now)
{
    next_knock_ = now + kKnockEvery;
    if (device_.waiting_count() > 0 || device_.is_read())
        return {};
    return device_.send(reports_[0].bytes());
}

Result<void> play_parts(DevicePlay const& play, std::atomic<bool> const& stop)
{
    while (!stop && !are_read(play))
        TRY(take_step(play));
    if (stop)
        return {};
    for (auto* const part : play.parts)
        part->begin(clock_now());
    if (play.on_begin)
        play.on_begin();
    while (!stop && !are_over(play))
        TRY(take_step(play));
    auto const end = clock_now() + kFarewell;
    while (!stop && clock_now() < end)
        TRY(take_step(play));
    return {};
}

} // namespace tractus
