#include "drivers/sensors/usb_sensor_list.h"

#include "drivers/links/sysfs.h"
#include "drivers/sensors/height_sensor_protocol.h"
#include "drivers/sensors/labjack_u3.h"
#include "drivers/usb/usb_interfaces.h"
#include "engine/base/file.h"

#include <optional>
#include <string>
#include <utility>

namespace tractus::drivers {

namespace fs = std::filesystem;

namespace {

bool is_own(UsbInterface const& interface)
{
    return interface.usb_class == kHeightSensorClass && interface.subclass == kHeightSensorSubclass
        && interface.protocol == kHeightSensorProtocol;
}

// Returns the index of the interface's string, found in the device's concatenated descriptors (USB
// 2.0, section 9.6.5).
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

std::optional<DeviceInfo> describe(UsbInterface const& interface)
{
    auto info = interface.info;
    info.location = "usb:" + interface.port;
    if (!is_own(interface) && !(is_labjack_u3(info) && info.interface_number == 0))
        return std::nullopt;
    if (info.name.empty())
        info.name = is_own(interface) ? "Height sensor" : "LabJack U3";
    if (auto text = read_sysfs_line(interface.folder / "interface");
        is_own(interface) && !text.empty())
        info.strings[string_index(interface.device_folder(), info.interface_number)]
            = std::move(text);
    return info;
}

} // namespace

std::vector<DeviceInfo> list_usb_height_sensors(fs::path const& folder)
{
    std::vector<DeviceInfo> sensors;
    for (auto const& interface : list_usb_interfaces(folder))
        if (auto info = describe(interface))
            sensors.push_back(*std::move(info));
    return sensors;
}

} // namespace tractus::drivers
