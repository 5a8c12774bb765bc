#include "app/diagnosis/udev_rules.h"

#include "drivers/device_address.h"

#include <fmt/core.h>

namespace tractus {

static constexpr std::uint16_t kUsb = 3; // linux/input.h

std::string udev_rules(RuleHolder holder)
{
    constexpr std::string_view kSeat = "TAG+=\"uaccess\"";
    constexpr std::string_view kGroup = "GROUP=\"plugdev\", MODE=\"0660\"";
    std::string text(udev_rules_text());
    if (holder == RuleHolder::Seat)
        return text;
    for (std::size_t at = 0; (at = text.find(kSeat, at)) != std::string::npos;) {
        bool const ends_a_rule = text.substr(at + kSeat.size(), 1) == "\n";
        text.replace(at, kSeat.size(), ends_a_rule ? kGroup : kSeat);
        at += kSeat.size();
    }
    return text;
}

std::string udev_rule_for(DeviceInfo const& info)
{
    auto const address = parse_device_address(info.location);
    if (address && std::holds_alternative<GpioAddress>(*address))
        return "SUBSYSTEM==\"gpio\", KERNEL==\"gpiochip*\", TAG+=\"uaccess\"";
    if (address && !std::holds_alternative<HidrawAddress>(*address))
        return fmt::format("SUBSYSTEM==\"usb\", ATTR{{idVendor}}==\"{:04x}\", "
                           "ATTR{{idProduct}}==\"{:04x}\", TAG+=\"uaccess\"",
                           info.vendor_id, info.product_id);
    if (info.bus == kUsb)
        return fmt::format("KERNEL==\"hidraw*\", ATTRS{{idVendor}}==\"{:04x}\", TAG+=\"uaccess\"",
                           info.vendor_id);
    return fmt::format("KERNEL==\"hidraw*\", KERNELS==\"{:04X}:{:04X}:*\", TAG+=\"uaccess\"",
                       info.bus, info.vendor_id);
}

} // namespace tractus
