#include "app/device_playback.h"

#include "engine/base/time.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <poll.h>

namespace tractus {

namespace {

constexpr auto kLongestWait = std::chrono::milliseconds(50); // Until `stop` is looked at again.

// Whoever opens a device only to see whether it can be opened does not read it.
constexpr auto kGreeting = std::chrono::milliseconds(100);

// For readers to take what the kernel still holds for them: once a device is gone, not all do.
constexpr auto kFarewell = std::chrono::milliseconds(100);

Timestamp now()
{
    return Timestamp(std::chrono::steady_clock::now().time_since_epoch());
}

class Playback {
public:
    Playback(Log const& log, std::span<PlayedDevice const> devices, PlaybackOptions const& options,
             std::atomic<bool> const& stop)
        : log_(log)
        , devices_(devices)
        , options_(options)
        , stop_(stop)
    {
    }

    Result<PlaybackCounts> run();

private:
    Result<void> serve_for(Duration longest);
    Result<void> serve_until(Timestamp time);
    Result<void> wait_for_readers();
    Result<void> send_reports();
    Result<void> wait_until_taken();
    PlayedDevice const* player_of(LogRecord const& record) const;
    bool is_any(bool (*condition)(KernelDevice const&)) const;

    Log const& log_;
    std::span<PlayedDevice const> devices_;
    PlaybackOptions const& options_;
    std::atomic<bool> const& stop_;
    std::vector<pollfd> files_ {}; // Kept for its memory.
    PlaybackCounts counts_ {};
};

// Answers what the kernel asks, once, as soon as it asks; gives up after `longest`.
Result<void> Playback::serve_for(Duration longest)
{
    files_.clear();
    for (auto const& played : devices_)
        played.device->add_files_to(files_);
    auto const nanoseconds = std::clamp<Duration>(longest, Duration::zero(), kLongestWait).count();
    timespec const timeout { .tv_sec = 0, .tv_nsec = nanoseconds };
    ::ppoll(files_.data(), files_.size(), &timeout, nullptr);
    for (auto const& played : devices_)
        TRY(played.device->serve());
    return {};
}

Result<void> Playback::serve_until(Timestamp time)
{
    do
        TRY(serve_for(time - now()));
    while (!stop_ && now() < time);
    return {};
}

bool Playback::is_any(bool (*condition)(KernelDevice const&)) const
{
    return std::any_of(devices_.begin(), devices_.end(),
                       [&](PlayedDevice const& played) { return condition(*played.device); });
}

Result<void> Playback::wait_for_readers()
{
    auto const unread = [](KernelDevice const& device) { return !device.is_read(); };
    while (!stop_ && is_any(unread)) {
        while (!stop_ && is_any(unread))
            TRY(serve_for(kLongestWait));
        TRY(serve_until(now() + kGreeting));
    }
    return {};
}

Result<void> Playback::wait_until_taken()
{
    while (!stop_ && is_any([](KernelDevice const& device) { return device.waiting_count() > 0; }))
        TRY(serve_for(kLongestWait));
    return serve_until(now() + kFarewell);
}

PlayedDevice const* Playback::player_of(LogRecord const& record) const
{
    auto const found
        = std::find_if(devices_.begin(), devices_.end(), [&](PlayedDevice const& played) {
              return played.log_device == record.device;
          });
    return found == devices_.end() ? nullptr : &*found;
}

Result<void> Playback::send_reports()
{
    auto const begin = now();
    std::optional<Timestamp> first; // The time in the log that is `begin`.
    for (auto const& record : log_.records) {
        auto const* const played = player_of(record);
        if (!played)
            continue;
        if (!first)
            first = record.time;
        auto due = begin + (record.time - *first);
        if (options_.rate_hz)
            due = begin + from_seconds(static_cast<double>(counts_.reports) / *options_.rate_hz);
        TRY(serve_until(options_.at_once ? begin : due));
        if (stop_)
            break;
        TRY(played->device->send(log_.report(record)));
        ++counts_.reports;
    }
    return {};
}

Result<PlaybackCounts> Playback::run()
{
    TRY(wait_for_readers());
    TRY(send_reports());
    TRY(wait_until_taken());
    while (options_.stay && !stop_)
        TRY(serve_for(kLongestWait));
    for (auto const& played : devices_)
        counts_.lost += played.device->lost_count();
    return counts_;
}

} // namespace

Result<PlaybackCounts> play_devices(Log const& log, std::span<PlayedDevice const> devices,
                                    PlaybackOptions const& options, std::atomic<bool> const& stop)
{
    return Playback(log, devices, options, stop).run();
}

} // namespace tractus
