#include "drivers/hid_sysfs.h"

#include "drivers/file.h"

#include <charconv>
#include <string_view>
#include <utility>

namespace tractus {

namespace fs = std::filesystem;

namespace {

// The first line of a file; empty if it cannot be read.
std::string read_line(fs::path const& file)
{
    auto text = read_file(file);
    if (!text)
        return {};
    return text->substr(0, text->find('\n'));
}

int read_hex(fs::path const& file, int otherwise)
{
    auto const text = read_line(file);
    std::from_chars(text.data(), text.data() + text.size(), otherwise, 16);
    return otherwise;
}

} // namespace

// …/usb1/1-2/1-2:1.0/0003:256C:006D.0005: the device, its interface, the HID device.
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
                       .interface_number = read_hex(interface / "bInterfaceNumber", -1),
                       .manufacturer = read_line(device / "manufacturer"),
                       .product = read_line(device / "product"),
                       .serial_number = read_line(device / "serial") };
}

std::string bound_driver(fs::path const& hidraw_folder)
{
    std::error_code error;
    auto const driver = fs::canonical(hidraw_folder / "device" / "driver", error);
    return error ? std::string() : driver.filename().string();
}

} // namespace tractus
