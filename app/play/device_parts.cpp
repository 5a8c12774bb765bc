#include "app/play/device_parts.h"

#include "drivers/reports/clock.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fmt/core.h>
#include <poll.h>
#include <utility>

namespace tractus::play {

namespace {

using Then = PlaybackSet::Then;

constexpr Duration kKnockEvery = std::chrono::milliseconds(10);
// Maximum time for which playing sleeps before it checks `stop`.
constexpr Duration kLongestSleep = std::chrono::milliseconds(50);
// Delay from the time at which every device has a reader to the first report: programs open a
// device for a trial before they open it to read.
constexpr Duration kGreeting = std::chrono::milliseconds(100);
// Longer delay for USB HID devices: Linux drops their reports of the first 50 ms as potentially
// stale.
constexpr Duration kUsbGreeting = std::chrono::milliseconds(500);
constexpr Duration kDrainTime = std::chrono::milliseconds(100);
constexpr Duration kLongestFarewell = std::chrono::seconds(2);

// Waits until one of the devices has a request, for at most `timeout`, and serves the devices.
Result<void> serve_devices(std::vector<sim::KernelDevice*> const& devices, Duration timeout)
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

// Plays everything that is due, then waits for the next event or for a request from the kernel.
Result<void> take_step(PlaybackSet const& play)
{
    auto next_due = Timestamp::max();
    for (auto* const part : play.parts) {
        if (auto const now = drivers::monotonic_now(); part->due() <= now)
            TRY(part->play(now));
        next_due = std::min(next_due, part->due());
    }
    bool const is_never = next_due == Timestamp::max();
    return serve_devices(play.devices,
                         is_never ? kLongestSleep : next_due - drivers::monotonic_now());
}

bool are_read(PlaybackSet const& play)
{
    return std::all_of(play.devices.begin(), play.devices.end(),
                       [](sim::KernelDevice const* device) { return device->is_read(); });
}

Duration greeting(PlaybackSet const& play)
{
    bool const is_usb = std::any_of(
        play.devices.begin(), play.devices.end(),
        [](sim::KernelDevice const* device) { return device->detects_readers_by_reports(); });
    return is_usb ? kUsbGreeting : kGreeting;
}

bool are_over(PlaybackSet const& play)
{
    auto const now = drivers::monotonic_now();
    return std::all_of(play.parts.begin(), play.parts.end(),
                       [&](DevicePart const* part) { return part->is_over(now); });
}

bool are_waiting(PlaybackSet const& play)
{
    return std::any_of(play.devices.begin(), play.devices.end(),
                       [](sim::KernelDevice const* device) { return device->waiting_count() > 0; });
}

void begin(PlaybackSet const& play)
{
    for (auto* const part : play.parts)
        part->begin(drivers::monotonic_now());
}

Result<void> go_on_for(Duration duration, PlaybackSet const& play, std::atomic<bool> const& stop)
{
    auto const end = drivers::monotonic_now() + duration;
    while (!stop && drivers::monotonic_now() < end)
        TRY(take_step(play));
    return {};
}

// Gives readers time to fetch the reports that are still queued here, and after that those that the
// kernel holds.
Result<void> say_farewell(PlaybackSet const& play, std::atomic<bool> const& stop)
{
    auto const latest = drivers::monotonic_now() + kLongestFarewell;
    while (!stop && are_waiting(play) && drivers::monotonic_now() < latest)
        TRY(take_step(play));
    return go_on_for(kDrainTime, play, stop);
}

} // namespace

ReportPart::ReportPart(sim::KernelDevice& device, std::function<NextReport()> reports)
    : device_(device)
    , reports_(std::move(reports))
{
    rewind();
}

void ReportPart::rewind()
{
    next_report_ = reports_();
    read_next();
}

void ReportPart::read_next()
{
    auto read = next_report_();
    next_ = read ? *read : std::nullopt;
    read_ = read ? Result<void>() : tl::unexpected(read.error());
}

void ReportPart::begin(Timestamp now)
{
    begin_ = now;
    rewind();
}

Timestamp ReportPart::due() const
{
    if (!read_)
        // An error in reading is due at once, so that play() reports it.
        return Timestamp::min();
    if (!begin_)
        return device_.detects_readers_by_reports() && next_ ? next_knock_ : Timestamp::max();
    return next_ ? *begin_ + next_->received.time_since_epoch() : Timestamp::max();
}

Result<void> ReportPart::play(Timestamp now)
{
    if (!read_)
        return read_;
    if (!begin_)
        return knock(now);
    while (next_ && due() <= now) {
        TRY(device_.send(next_->bytes()));
        read_next();
    }
    return {};
}

// Sends the first report before playing starts, for devices that notice a reader only when a report
// is fetched. Programs rarely see this report (see kUsbGreeting); it is sent again when playing
// starts.
Result<void> ReportPart::knock(Timestamp now)
{
    next_knock_ = now + kKnockEvery;
    if (device_.waiting_count() > 0 || device_.is_read())
        return {};
    return device_.send(next_->bytes());
}

Result<void> play_parts(PlaybackSet const& play, std::atomic<bool> const& stop)
{
    while (!stop && !are_read(play)) {
        while (!stop && !are_read(play))
            TRY(take_step(play));
        TRY(go_on_for(greeting(play), play, stop));
    }
    if (stop)
        return {};
    begin(play);
    if (play.on_begin)
        play.on_begin();
    while (!stop && (play.then != Then::Leave || !are_over(play))) {
        if (play.then == Then::Repeat && are_over(play))
            begin(play);
        TRY(take_step(play));
    }
    return say_farewell(play, stop);
}

} // namespace tractus::play
