#include "drivers/tablets/tablet_interfaces.h"
#include "drivers/tablets/pen_decoders.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus::drivers {

// Returns a key that is the same for all interfaces of a USB device: their paths differ only in the
// interface number.
static std::string tablet_key(DeviceInfo const& info)
{
    auto const path = info.physical_path.substr(0, info.physical_path.rfind("/input"));
    return fmt::format("{}:{:04x}:{:04x}:{}:{}", info.bus, info.vendor_id, info.product_id,
                       info.serial_number, path.empty() ? info.location : path);
}

bool carries_pen(DeviceInfo const& info)
{
    return make_pen_decoder(info).has_value();
}

std::vector<std::vector<DeviceInfo>> group_by_tablet(std::vector<DeviceInfo> const& devices)
{
    std::vector<std::vector<DeviceInfo>> groups;
    for (auto const& info : devices) {
        auto const key = tablet_key(info);
        auto group = std::find_if(groups.begin(), groups.end(), [&](auto const& others) {
            return tablet_key(others.front()) == key;
        });
        if (group == groups.end())
            group = groups.insert(group, std::vector<DeviceInfo>());
        group->push_back(info);
    }
    return groups;
}

} // namespace tractus::drivers
