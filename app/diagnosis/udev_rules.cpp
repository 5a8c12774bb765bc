#include "app/diagnosis/udev_rules.h"

#include "drivers/reports/device_address.h"

#include <algorithm>
#include <cstddef>
#include <fmt/core.h>

namespace tractus::diagnosis {

static constexpr std::uint16_t kUsb = 3; // Bus number of USB, BUS_USB in linux/input.h.

// True if the descriptor matches the udev rule that recognises pens by their usage.
static bool describes_pen_to_udev(std::vector<std::byte> const& descriptor)
{
    auto const at = [&](std::size_t i) {
        return i < descriptor.size() ? std::to_integer<int>(descriptor[i]) : -1;
    };
    for (std::size_t i = 0; i < descriptor.size(); ++i) {
        bool const is_page = (at(i) == 0x05 || at(i) == 0x06) && at(i + 1) == 0x0d;
        auto const usage = at(i + 2) == 0x00 || at(i + 2) == 0xff ? i + 3 : i + 2;
        auto const id = at(usage + 1);
        if (is_page && at(usage) == 0x09 && (id == 0x01 || id == 0x02 || id == 0x20))
            return true;
    }
    return false;
}

// Returns the text from the end of `key`, which ends in ==", to the next quotation mark. Empty if
// the line does not contain the key.
static std::string_view value_of_key(std::string_view line, std::string_view key)
{
    auto const start = line.find(key);
    if (start == std::string_view::npos)
        return {};
    auto const value = line.substr(start + key.size());
    return value.substr(0, value.find('"'));
}

static bool names_id(std::string_view alternatives, std::uint16_t id)
{
    return fmt::format("|{}|", alternatives).find(fmt::format("|{:04x}|", id)) != std::string::npos;
}

static bool does_line_permit(std::string_view line, drivers::DeviceInfo const& info)
{
    bool const is_for_nodes = !line.starts_with('#') && !line.starts_with("SUBSYSTEM")
        && line.find("TAG+=\"uaccess\"") != std::string_view::npos;
    if (!is_for_nodes)
        return false;
    if (line.starts_with("PROGRAM"))
        return describes_pen_to_udev(info.report_descriptor);
    if (auto const parent = value_of_key(line, "KERNELS==\""); !parent.empty())
        return parent == fmt::format("{:04X}:{:04X}:*", info.bus, info.vendor_id);
    auto const products = value_of_key(line, "ATTRS{idProduct}==\"");
    return info.bus == kUsb && names_id(value_of_key(line, "ATTRS{idVendor}==\""), info.vendor_id)
        && (products.empty() || names_id(products, info.product_id));
}

bool do_rules_permit(drivers::DeviceInfo const& info)
{
    auto const address = drivers::parse_device_address(info.location);
    if (!address || !std::holds_alternative<drivers::HidrawAddress>(*address))
        // Devices of other kinds are covered by rules on USB classes, which DeviceInfo does not
        // contain.
        return true;
    for (auto text = udev_rules_text(); !text.empty();) {
        auto const line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        if (does_line_permit(line, info))
            return true;
    }
    return false;
}

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

std::string udev_rule_for(drivers::DeviceInfo const& info)
{
    auto const address = drivers::parse_device_address(info.location);
    if (address && drivers::is_on_gpio(*address))
        return "SUBSYSTEM==\"gpio\", KERNEL==\"gpiochip*\", TAG+=\"uaccess\"";
    if (address && std::holds_alternative<drivers::SerialAddress>(*address))
        return fmt::format("SUBSYSTEM==\"tty\", ATTRS{{idVendor}}==\"{:04x}\", "
                           "ATTRS{{idProduct}}==\"{:04x}\", TAG+=\"uaccess\"",
                           info.vendor_id, info.product_id);
    if (address && !std::holds_alternative<drivers::HidrawAddress>(*address))
        return fmt::format("SUBSYSTEM==\"usb\", ATTR{{idVendor}}==\"{:04x}\", "
                           "ATTR{{idProduct}}==\"{:04x}\", TAG+=\"uaccess\"",
                           info.vendor_id, info.product_id);
    if (info.bus == kUsb)
        return fmt::format("KERNEL==\"hidraw*\", ATTRS{{idVendor}}==\"{:04x}\", "
                           "ATTRS{{idProduct}}==\"{:04x}\", TAG+=\"uaccess\"",
                           info.vendor_id, info.product_id);
    return fmt::format("KERNEL==\"hidraw*\", KERNELS==\"{:04X}:{:04X}:{:04X}.*\", TAG+=\"uaccess\"",
                       info.bus, info.vendor_id, info.product_id);
}

} // namespace tractus::diagnosis
