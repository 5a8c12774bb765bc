#pragma once

#include <libudev.h>
#include <memory>

namespace tractus::drivers {

/// Deleter for libudev objects: `std::unique_ptr<udev_device, UdevUnreference>`.
struct UdevUnreference {
    void operator()(udev* context) const { udev_unref(context); }
    void operator()(udev_monitor* monitor) const { udev_monitor_unref(monitor); }
    void operator()(udev_device* device) const { udev_device_unref(device); }
};

} // namespace tractus::drivers
