#include "drivers/links/event_source.h"

#include "drivers/links/sysfs.h"
#include "engine/base/time.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <fmt/core.h>
#include <libevdev/libevdev.h>
#include <poll.h>
#include <string>
#include <unistd.h>
#include <utility>

namespace tractus::drivers {

namespace fs = std::filesystem;

namespace {

struct FreeEvdev {
    void operator()(libevdev* device) const
    {
        auto const file = libevdev_get_fd(device);
        libevdev_free(device);
        if (file >= 0)
            ::close(file);
    }
};
using Evdev = std::unique_ptr<libevdev, FreeEvdev>;

Result<Evdev> open_evdev(std::string const& node)
{
    auto const file = ::open(node.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (file < 0)
        return fail(Fault::User,
                    fmt::format("cannot open {}: {}{}", node, std::strerror(errno),
                                errno == EACCES ? " (its group may: sudo adduser $USER input, then "
                                                  "log in again)"
                                                : ""));
    libevdev* device = nullptr;
    if (auto const error = libevdev_new_from_fd(file, &device); error < 0) {
        ::close(file);
        return fail(Fault::User,
                    fmt::format("{} is no input device: {}", node, std::strerror(-error)));
    }
    return Evdev(device);
}

class EventSource final : public ReportSource {
public:
    EventSource(DeviceInfo info, Evdev device, EventAbilities const& abilities)
        : info_(std::move(info))
        , device_(std::move(device))
        , pen_(abilities)
    {
        libevdev_set_clock_id(device_.get(), CLOCK_MONOTONIC);
        for (auto const& [code, axis] : abilities.axes)
            pen_.push(EV_ABS, code, libevdev_get_event_value(device_.get(), EV_ABS, code));
        for (auto const code : abilities.keys)
            pen_.push(EV_KEY, code, libevdev_get_event_value(device_.get(), EV_KEY, code));
    }

    DeviceInfo const& info() const override { return info_; }
    Result<std::optional<RawReport>> read(Duration timeout) override;

private:
    Result<std::optional<RawReport>> take_waiting();

    DeviceInfo info_;
    Evdev device_;
    EventPen pen_;
    // True while libevdev reports the state that results from events dropped by the kernel.
    bool is_catching_up_ = false;
};

// Returns the next complete report among the pending events.
Result<std::optional<RawReport>> EventSource::take_waiting()
{
    for (;;) {
        input_event event {};
        auto const status = libevdev_next_event(
            device_.get(), is_catching_up_ ? LIBEVDEV_READ_FLAG_SYNC : LIBEVDEV_READ_FLAG_NORMAL,
            &event);
        if (status == -EAGAIN && std::exchange(is_catching_up_, false))
            continue;
        if (status == -EAGAIN || status == -EINTR)
            return std::optional<RawReport>();
        if (status < 0)
            return fail(Fault::Device, fmt::format("{} at {} is gone", info_.name, info_.location));
        is_catching_up_ |= status == LIBEVDEV_READ_STATUS_SYNC;
        if (event.type == EV_SYN && event.code == SYN_DROPPED)
            continue;
        auto const bytes = pen_.push(event.type, event.code, event.value);
        if (bytes.empty())
            continue;
        RawReport report { .received
                           = Timestamp(std::chrono::seconds(event.input_event_sec)
                                       + std::chrono::microseconds(event.input_event_usec)),
                           .size = bytes.size() };
        std::ranges::copy(bytes, report.storage.begin());
        return std::optional(report);
    }
}

Result<std::optional<RawReport>> EventSource::read(Duration timeout)
{
    auto const end = std::chrono::steady_clock::now() + timeout;
    for (;;) {
        if (auto report = TRY(take_waiting()))
            return report;
        auto const left
            = std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        if (left.count() <= 0)
            return std::optional<RawReport>();
        pollfd waiting { .fd = libevdev_get_fd(device_.get()), .events = POLLIN, .revents = 0 };
        ::poll(&waiting, 1, static_cast<int>(std::min<std::int64_t>(left.count(), 1000)));
    }
}

// Tests bit `code` of a bit map in sysfs format: words of the size of a long, most significant
// first, without leading zeros.
bool has_sysfs_bit(std::string const& map, unsigned code)
{
    constexpr unsigned kWordBits = 8 * sizeof(long);
    auto end = map.size();
    for (unsigned word = code / kWordBits; word > 0; --word) {
        auto const blank = map.rfind(' ', end == 0 ? 0 : end - 1);
        if (blank == std::string::npos)
            return false;
        end = blank;
    }
    auto const blank = end == 0 ? std::string::npos : map.rfind(' ', end - 1);
    auto const begin = blank == std::string::npos ? 0 : blank + 1;
    unsigned long value = 0;
    std::from_chars(map.data() + begin, map.data() + end, value, 16);
    return (value >> (code % kWordBits) & 1) != 0;
}

// True if sysfs lists the keys and axes of a pen. The ranges of axes are not in sysfs.
bool may_be_event_pen(fs::path const& device)
{
    auto const keys = read_sysfs_line(device / "capabilities/key");
    auto const axes = read_sysfs_line(device / "capabilities/abs");
    return has_sysfs_bit(axes, ABS_X) && has_sysfs_bit(axes, ABS_Y)
        && (has_sysfs_bit(keys, BTN_TOOL_PEN) || has_sysfs_bit(keys, BTN_STYLUS))
        && (has_sysfs_bit(keys, BTN_TOUCH) || has_sysfs_bit(axes, ABS_PRESSURE));
}

std::uint16_t sysfs_id(fs::path const& device, char const* name)
{
    return static_cast<std::uint16_t>(read_sysfs_number(device / "id" / name, 16));
}

} // namespace

EventAbilities abilities_of(libevdev const& device)
{
    EventAbilities abilities;
    for (unsigned code = 0; code < KEY_CNT; ++code)
        if (libevdev_has_event_code(&device, EV_KEY, code) != 0)
            abilities.keys.insert(static_cast<std::uint16_t>(code));
    for (unsigned code = 0; code < ABS_CNT; ++code)
        if (auto const* const axis = libevdev_get_abs_info(&device, code))
            abilities.axes[static_cast<std::uint16_t>(code)] = { .minimum = axis->minimum,
                                                                 .maximum = axis->maximum,
                                                                 .resolution = axis->resolution };
    return abilities;
}

std::vector<DeviceInfo> list_event_pens(fs::path const& root)
{
    std::vector<DeviceInfo> pens;
    std::error_code error;
    for (auto const& entry : fs::directory_iterator(root / "sys/class/input", error)) {
        auto const name = entry.path().filename().string();
        auto const device = entry.path() / "device";
        // Skips the event nodes of HID devices, which also have a hidraw node.
        if (!name.starts_with("event") || fs::exists(device / "device/hidraw", error)
            || !may_be_event_pen(device))
            continue;
        DeviceInfo info { .name = read_sysfs_line(device / "name"),
                          .location = "/dev/input/" + name,
                          .physical_path = event_pen_path(read_sysfs_line(device / "phys")),
                          .bus = sysfs_id(device, "bustype"),
                          .vendor_id = sysfs_id(device, "vendor"),
                          .product_id = sysfs_id(device, "product") };
        if (auto const opened = open_evdev((root / "dev/input" / name).string()))
            if (auto const abilities = abilities_of(**opened); is_event_pen(abilities))
                info.report_descriptor = describe_event_pen(abilities);
        pens.push_back(std::move(info));
    }
    std::ranges::sort(pens, {}, &DeviceInfo::location);
    return pens;
}

Result<std::unique_ptr<ReportSource>> open_event_pen(DeviceInfo info)
{
    auto device = TRY(open_evdev(info.location));
    auto const abilities = abilities_of(*device);
    if (!is_event_pen(abilities))
        return fail(Fault::User, fmt::format("{} at {} is no pen", info.name, info.location));
    info.report_descriptor = describe_event_pen(abilities);
    return std::make_unique<EventSource>(std::move(info), std::move(device), abilities);
}

} // namespace tractus::drivers
