#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/usb/usb_context.h"
#include "engine/base/result.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus::drivers {

// Reads the string descriptors of a USB device, even while other programs use its interfaces: a
// control transfer to the device does not need an interface. The device is opened at the first
// request.
class UsbStrings {
public:
    // `usb_address` is like "1-2.3"; empty for a device that is not on USB.
    explicit UsbStrings(std::string usb_address)
        : address_(std::move(usb_address))
    {
    }

    // Reads a string descriptor like TabletPort::read_string().
    Result<std::string> read(int index);

private:
    std::string address_;
    std::optional<UsbDevice> device_;
};

// Lists all HID interfaces on USB with their libusb addresses, "libusb:1-2.3:0", sorted by port.
// Reads only sysfs, so report descriptors are missing: only an open device provides them.
std::vector<DeviceInfo> list_usb_tablets(std::filesystem::path const& devices_folder
                                         = "/sys/bus/usb/devices");

// Describes the device at `info.location`, including its report descriptor, for which the kernel's
// driver is detached for a moment; settings are kept. Fails with a user error if there is no
// such device or it may not be opened.
Result<DeviceInfo> describe_usb_tablet(DeviceInfo info);

} // namespace tractus::drivers
