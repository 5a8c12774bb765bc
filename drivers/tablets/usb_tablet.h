#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/usb/usb_context.h"
#include "engine/base/result.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus::drivers {

// The string descriptors of a USB device, asked for while its interfaces are in use by others: a
// control transfer to the device needs none of them. Opens the device at the first one.
class UsbStrings {
public:
    // "1-2.3"; empty for a device that is not on USB.
    explicit UsbStrings(std::string usb_address)
        : address_(std::move(usb_address))
    {
    }

    // Does as TabletPort::read_string.
    Result<std::string> read(int index);

private:
    std::string address_;
    std::optional<UsbDevice> device_;
};

// Every HID interface on USB by its address for libusb, "libusb:1-2.3:0", in the order of the
// ports. Reads sysfs alone, so the report descriptors, which a device tells only when it is opened,
// are missing.
std::vector<DeviceInfo> list_usb_tablets(std::filesystem::path const& devices_folder
                                         = "/sys/bus/usb/devices");

// The one at `info.location`, with its report descriptor, for which the interface is taken from the
// kernel's driver for a moment; settings are kept. Fails, as the user's fault, if there is no such
// device or it may not be opened.
Result<DeviceInfo> describe_usb_tablet(DeviceInfo info);

} // namespace tractus::drivers
