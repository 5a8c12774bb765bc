#include "drivers/links/device_events.h"

#include "drivers/links/udev_handles.h"

#include <chrono>
#include <filesystem>
#include <poll.h>
#include <string_view>

namespace tractus::drivers {

namespace {

class UdevEvents final : public DeviceEvents {
public:
    explicit UdevEvents(std::unique_ptr<udev_monitor, UdevUnreference> monitor)
        : monitor_(std::move(monitor))
    {
    }

    bool wait(Duration timeout) override;

private:
    bool take();

    std::unique_ptr<udev_monitor, UdevUnreference> monitor_;
};

// Drains all pending events. Returns true if one of them concerns a device that can now be opened.
bool UdevEvents::take()
{
    bool is_any = false;
    while (std::unique_ptr<udev_device, UdevUnreference> const device {
        udev_monitor_receive_device(monitor_.get()) }) {
        auto const* const action = udev_device_get_action(device.get());
        is_any |= !action || std::string_view(action) != "remove";
    }
    return is_any;
}

bool UdevEvents::wait(Duration timeout)
{
    auto const end = std::chrono::steady_clock::now() + timeout;
    while (!take()) {
        auto const left
            = std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        if (left.count() <= 0)
            return false;
        pollfd socket { .fd = udev_monitor_get_fd(monitor_.get()), .events = POLLIN, .revents = 0 };
        ::poll(&socket, 1, static_cast<int>(left.count()));
    }
    return true;
}

} // namespace

std::unique_ptr<DeviceEvents> listen_to_udev()
{
    std::error_code ignored;
    if (!std::filesystem::exists("/run/udev/control", ignored))
        return nullptr;
    std::unique_ptr<udev, UdevUnreference> const context(udev_new());
    if (!context)
        return nullptr;
    std::unique_ptr<udev_monitor, UdevUnreference> monitor(
        udev_monitor_new_from_netlink(context.get(), "udev"));
    if (!monitor)
        return nullptr;
    for (auto const* const subsystem : { "hidraw", "usb", "tty", "iio", "input" })
        if (udev_monitor_filter_add_match_subsystem_devtype(monitor.get(), subsystem, nullptr) < 0)
            return nullptr;
    if (udev_monitor_enable_receiving(monitor.get()) < 0)
        return nullptr;
    return std::make_unique<UdevEvents>(std::move(monitor));
}

} // namespace tractus::drivers
