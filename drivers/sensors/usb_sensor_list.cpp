#include "drivers/sensors/usb_sensor_list.h"

#include "drivers/file.h"
#include "drivers/sensors/height_sensor_protocol.h"
#include "drivers/sensors/labjack_u3.h"

#include <algorithm>
#include <charconv>
#include <fmt/core.h>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace tractus {

namespace fs = std::filesystem;

namespace {

// The text in a file of sysfs, without its line break; empty if there is none.
std::string text_of(fs::path const& file)
{
    auto text = read_file(file).value_or(std::string());
    if (text.ends_with('\n'))
        text.pop_back();
    return text;
}

// A number of hexadecimal digits; 0 if it is none.
std::uint16_t hexadecimal(fs::path const& file)
{
    auto const text = text_of(file);
    std::uint16_t value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value, 16);
    return value;
}

bool is_own_interface(fs::path const& interface)
{
    return hexadecimal(interface / "bInterfaceClass") == kHeightSensorClass
        && hexadecimal(interface / "bInterfaceSubClass") == kHeightSensorSubclass
        && hexadecimal(interface / "bInterfaceProtocol") == kHeightSensorProtocol;
}

// The number of the interface's string, from the device's descriptors one after another (USB 2.0
// section 9.6.5).
int string_index(fs::path const& device, int interface_number)
{
    constexpr unsigned char kInterface = 4;
    auto const bytes = read_file(device / "descriptors").value_or(std::string());
    auto const at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    for (std::size_t i = 0; i + 9 <= bytes.size() && at(i) > 0; i += at(i))
        if (at(i) >= 9 && at(i + 1) == kInterface && at(i + 2) == interface_number)
            return at(i + 8);
    return 0;
}

// `interface` is the folder of one interface, "1-2.3:1.0", among those of the devices.
std::optional<DeviceInfo> describe(fs::path const& interface)
{
    auto const name = interface.filename().string();
    auto const port = name.substr(0, name.find(':'));
    auto const device = interface.parent_path() / port;
    DeviceInfo info { .name = text_of(device / "product"),
                      .manufacturer = text_of(device / "manufacturer"),
                      .serial_number = text_of(device / "serial"),
                      .location = "usb:" + port,
                      .interface_number = hexadecimal(interface / "bInterfaceNumber"),
                      .vendor_id = hexadecimal(device / "idVendor"),
                      .product_id = hexadecimal(device / "idProduct") };
    info.physical_path = fmt::format("usb-{}/input{}", port, info.interface_number);
    bool const is_own = is_own_interface(interface);
    if (!is_own && !(is_labjack_u3(info) && info.interface_number == 0))
        return std::nullopt;
    if (info.name.empty())
        info.name = is_own ? "Height sensor" : "LabJack U3";
    if (auto text = text_of(interface / "interface"); is_own && !text.empty())
        info.strings[string_index(device, info.interface_number)] = std::move(text);
    return info;
}

// 1-10 after 1-9.
bool comes_first(DeviceInfo const& a, DeviceInfo const& b)
{
    return std::pair(a.location.size(), a.location) < std::pair(b.location.size(), b.location);
}

} // namespace

std::vector<DeviceInfo> list_usb_height_sensors(fs::path const& folder)
{
    std::vector<DeviceInfo> sensors;
    std::error_code ignored; // No folder, no devices.
    for (fs::directory_iterator entry(folder, ignored); entry != fs::directory_iterator();
         entry.increment(ignored))
        if (entry->path().filename().string().find(':') != std::string::npos)
            if (auto info = describe(entry->path()))
                sensors.push_back(*std::move(info));
    std::sort(sensors.begin(), sensors.end(), comes_first);
    return sensors;
}

} // namespace tractus
