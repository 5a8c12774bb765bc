#include "drivers/usb/usb_interfaces.h"

#include "drivers/links/sysfs.h"

#include <algorithm>
#include <fmt/core.h>
#include <tuple>
#include <utility>

namespace tractus::drivers {

namespace fs = std::filesystem;

static UsbInterface describe(fs::path const& folder)
{
    auto const name = folder.filename().string();
    UsbInterface interface {
        .folder = folder, .port = name.substr(0, name.find(':')),
        .usb_class = read_sysfs_number(folder / "bInterfaceClass", 16),
        .subclass = read_sysfs_number(folder / "bInterfaceSubClass", 16),
        .protocol = read_sysfs_number(folder / "bInterfaceProtocol", 16)
    };
    auto const device = interface.device_folder();
    auto const read_id = [&](char const* file) {
        return static_cast<std::uint16_t>(read_sysfs_number(device / file, 16));
    };
    auto& info = interface.info;
    info.name = read_sysfs_line(device / "product");
    info.manufacturer = read_sysfs_line(device / "manufacturer");
    info.serial_number = read_sysfs_line(device / "serial");
    info.vendor_id = read_id("idVendor");
    info.product_id = read_id("idProduct");
    info.interface_number = read_sysfs_number(folder / "bInterfaceNumber", 16);
    info.physical_path = fmt::format("usb-{}/input{}", interface.port, info.interface_number);
    return interface;
}

// Sorts by port and interface number, with port 1-10 after 1-9.
static bool comes_first(UsbInterface const& a, UsbInterface const& b)
{
    auto const place = [](UsbInterface const& interface) {
        return std::tuple(interface.port.size(), std::string_view(interface.port),
                          interface.info.interface_number);
    };
    return place(a) < place(b);
}

std::vector<UsbInterface> list_usb_interfaces(fs::path const& folder)
{
    std::vector<UsbInterface> interfaces;
    std::error_code ignored; // A missing folder means that there are no devices.
    for (fs::directory_iterator entry(folder, ignored); entry != fs::directory_iterator();
         entry.increment(ignored))
        if (entry->path().filename().string().find(':') != std::string::npos)
            interfaces.push_back(describe(entry->path()));
    std::sort(interfaces.begin(), interfaces.end(), comes_first);
    return interfaces;
}

} // namespace tractus::drivers
