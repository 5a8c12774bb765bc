#include "app/diagnosis/system_facts.h"

#include "drivers/device_list.h"
#include "drivers/library_versions.h"
#include "drivers/links/hid_source.h"
#include "drivers/links/sysfs.h"
#include "drivers/reports/device_address.h"
#include "drivers/tablets/tablet_lookup.h"
#include "engine/base/file.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fmt/core.h>
#include <unistd.h>

namespace tractus::diagnosis {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> entries_of(fs::path const& folder)
{
    std::vector<fs::path> entries;
    std::error_code ignored;
    for (fs::directory_iterator entry(folder, ignored); entry != fs::directory_iterator();
         entry.increment(ignored))
        entries.push_back(entry->path());
    std::sort(entries.begin(), entries.end());
    return entries;
}

// True if a HID device of this USB interface has a hidraw node. The folder of a HID device is named
// by its ids, such as "0003:056A:037A.0001", and contains the folder of its node.
bool has_node(fs::path const& interface)
{
    std::error_code ignored;
    for (auto const& entry : entries_of(interface))
        if (fs::exists(entry / "hidraw", ignored))
            return true;
    return false;
}

UsbDeviceFacts describe_usb(fs::path const& folder)
{
    UsbDeviceFacts device {
        .port = folder.filename().string(),
        .vendor_id
        = static_cast<std::uint16_t>(drivers::read_sysfs_number(folder / "idVendor", 16)),
        .product_id
        = static_cast<std::uint16_t>(drivers::read_sysfs_number(folder / "idProduct", 16)),
        .name = drivers::read_sysfs_line(folder / "product"),
    };
    for (auto const& entry : entries_of(folder)) {
        if (!entry.filename().string().starts_with(device.port + ":"))
            continue;
        device.interfaces.push_back(
            { .number = drivers::read_sysfs_number(entry / "bInterfaceNumber", 16),
              .usb_class = drivers::read_sysfs_number(entry / "bInterfaceClass", 16),
              .driver = drivers::read_sysfs_link(entry / "driver"),
              .has_node = has_node(entry) });
    }
    return device;
}

std::vector<UsbDeviceFacts> gather_usb(fs::path const& root)
{
    std::vector<UsbDeviceFacts> devices;
    for (auto const& folder : entries_of(root / "sys/bus/usb/devices")) {
        auto const name = folder.filename().string();
        // Root hubs ("usb1") and interfaces ("1-2:1.0") are not devices.
        if (name.find(':') == std::string::npos && !name.starts_with("usb"))
            devices.push_back(describe_usb(folder));
    }
    return devices;
}

// Describes a HID device without a node. Its folder is named by bus and ids, such as
// "0003:04D8:00DD.0001".
HiddenHidFacts describe_hidden(fs::path const& folder)
{
    HiddenHidFacts device { .name = folder.filename().string(),
                            .driver = drivers::read_sysfs_link(folder / "driver") };
    auto const id_at = [&](std::size_t at) {
        std::uint16_t id = 0;
        if (device.name.size() >= at + 4)
            std::from_chars(device.name.data() + at, device.name.data() + at + 4, id, 16);
        return id;
    };
    device.vendor_id = id_at(5);
    device.product_id = id_at(10);
    return device;
}

std::vector<HiddenHidFacts> gather_hidden(fs::path const& root)
{
    std::vector<HiddenHidFacts> devices;
    std::error_code ignored;
    for (auto const& folder : entries_of(root / "sys/bus/hid/devices"))
        if (!fs::exists(folder / "hidraw", ignored))
            devices.push_back(describe_hidden(folder));
    return devices;
}

// Returns the polling rate of the interface's first endpoint that sends to the computer. The file
// "interval" contains a text such as "8ms", "1ms" or "125us".
std::optional<double> poll_rate_hz(fs::path const& interface)
{
    for (auto const& entry : entries_of(interface)) {
        if (!entry.filename().string().starts_with("ep_8"))
            continue;
        auto const text = drivers::read_sysfs_line(entry / "interval");
        double value = 0;
        auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        auto const unit
            = std::string_view(text).substr(static_cast<std::size_t>(end - text.data()));
        if (error != std::errc() || value <= 0 || (unit != "ms" && unit != "us"))
            return std::nullopt;
        return (unit == "ms" ? 1e3 : 1e6) / value;
    }
    return std::nullopt;
}

DeviceFacts describe(drivers::DeviceInfo const& info, fs::path const& root)
{
    DeviceFacts facts { .info = info,
                        .description = drivers::describe_device(info),
                        .open_error = opening_error(info, root),
                        .poll_hz = {} };
    if (auto const match = drivers::find_tablet(info)) {
        facts.tablet = drivers::tablet_name(*match);
        facts.family = match->identifier->family;
    }
    auto const node = fs::path(info.location).filename();
    if (info.location.starts_with("/dev/hidraw")) {
        auto const device = root / "sys/class/hidraw" / node / "device";
        facts.driver = drivers::read_sysfs_link(device / "driver");
        std::error_code ignored;
        auto const interface = fs::canonical(device, ignored).parent_path();
        facts.poll_hz = poll_rate_hz(interface);
    }
    return facts;
}

bool has_rules(fs::path const& root)
{
    std::error_code ignored;
    for (auto const* const folder : { "etc/udev/rules.d", "lib/udev/rules.d",
                                      "usr/lib/udev/rules.d", "usr/local/lib/udev/rules.d" })
        if (fs::exists(root / folder / "70-tractus.rules", ignored))
            return true;
    return false;
}

int access_error(fs::path const& path)
{
    return ::access(path.c_str(), R_OK | W_OK) == 0 ? 0 : errno;
}

} // namespace

int opening_error(drivers::DeviceInfo const& info, fs::path const& root)
{
    auto const address = drivers::parse_device_address(info.location);
    if (!address)
        return 0;
    if (auto const* const hidraw = std::get_if<drivers::HidrawAddress>(&*address))
        return access_error(root / fs::path(hidraw->node).relative_path());
    auto const chip_error = [&](std::string const& chip) {
        return chip.starts_with("gpiochip") ? access_error(root / "dev" / chip) : 0;
    };
    if (auto const* const gpio = std::get_if<drivers::GpioAddress>(&*address))
        return chip_error(gpio->chip);
    if (auto const* const encoder = std::get_if<drivers::GpioEncoderAddress>(&*address))
        return chip_error(encoder->chip);
    if (auto const* const serial = std::get_if<drivers::SerialAddress>(&*address))
        return access_error(root / fs::path(serial->node).relative_path());
    if (auto const* const event = std::get_if<drivers::EventAddress>(&*address))
        return access_error(root / fs::path(event->node).relative_path());
    if (std::holds_alternative<drivers::IioAddress>(*address))
        return 0; // Every user may read industrial I/O devices.
    auto const* const usb = std::get_if<drivers::UsbAddress>(&*address);
    auto const& port = usb ? usb->port : std::get<drivers::LibusbAddress>(*address).port;
    auto const folder = root / "sys/bus/usb/devices" / drivers::print_usb_port(port);
    return access_error(root
                        / fmt::format("dev/bus/usb/{:03}/{:03}",
                                      drivers::read_sysfs_number(folder / "busnum", 10),
                                      drivers::read_sysfs_number(folder / "devnum", 10)));
}

SystemFacts gather_system_facts(fs::path const& root)
{
    SystemFacts facts { .usb = gather_usb(root), .hidden = gather_hidden(root) };
    auto const devices
        = root == "/" ? drivers::list_devices() : drivers::enumerate_hid(root / "sys/class/hidraw");
    for (auto const& info : devices)
        facts.devices.push_back(describe(info, root));
    for (auto const& library : drivers::library_versions())
        facts.libraries.push_back({ library.name, library.version, library.needed });
    std::error_code ignored;
    facts.has_hidraw = fs::exists(root / "sys/class/hidraw", ignored);
    facts.has_our_rules = has_rules(root);
    return facts;
}

} // namespace tractus::diagnosis
