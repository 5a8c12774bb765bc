#include "drivers/links/hid_sysfs.h"

#include "drivers/links/sysfs.h"

namespace tractus::drivers {

namespace fs = std::filesystem;

// In a path such as …/usb1/1-2/1-2:1.0/0003:256C:006D.0005, the last three folders are the USB
// device, its interface, and the HID device.
std::optional<UsbParent> find_usb_parent(fs::path const& hidraw_folder)
{
    std::error_code error;
    auto const hid = fs::canonical(hidraw_folder / "device", error);
    if (error)
        return std::nullopt;
    auto const interface = hid.parent_path();
    auto const device = interface.parent_path();
    if (!fs::exists(interface / "bInterfaceNumber", error) || !fs::exists(device / "busnum", error))
        return std::nullopt;
    return UsbParent { .address = device.filename().string(),
                       .interface_number
                       = read_sysfs_number(interface / "bInterfaceNumber", 16, -1),
                       .manufacturer = read_sysfs_line(device / "manufacturer"),
                       .product = read_sysfs_line(device / "product"),
                       .serial_number = read_sysfs_line(device / "serial") };
}

std::string bound_driver(fs::path const& hidraw_folder)
{
    std::error_code error;
    auto const driver = fs::canonical(hidraw_folder / "device" / "driver", error);
    return error ? std::string() : driver.filename().string();
}

} // namespace tractus::drivers
