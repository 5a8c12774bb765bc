#include "drivers/tablets/mode_switch.h"

#include "drivers/tablets/tablet_lookup.h"

#include <fmt/core.h>

namespace tractus::drivers {

namespace {

Result<void> read_strings(DeviceInfo& info, TabletPort& port, std::vector<int> const& indices)
{
    for (int const index : indices)
        if (!info.strings.contains(index))
            info.strings[index] = TRY(port.read_string(index));
    return {};
}

using Send = Result<void> (TabletPort::*)(std::span<std::byte const>);

Result<void> send_all(TabletPort& port, Send send,
                      std::vector<std::vector<std::byte>> const& reports)
{
    for (auto const& report : reports)
        TRY((port.*send)(report));
    return {};
}

} // namespace

void switch_to_full_mode(DeviceInfo& info, TabletPort& port, SwitchedBy switched_by)
{
    auto const identified
        = read_strings(info, port, identifying_strings(info.vendor_id, info.product_id));
    auto const match = find_tablet(info);
    if (!match || match->identifier->family == kPadFamily)
        return;
    auto const& setup = match->identifier->setup;
    auto const warn = [&](Result<void> const& result) {
        if (!result && switched_by == SwitchedBy::Nobody)
            info.warnings.push_back(fmt::format(
                "cannot switch {} to its full mode, so it stays in the one it is in: {}",
                match->tablet->name, result.error().message));
    };
    if (!identified && match->alternatives > 0 && switched_by == SwitchedBy::Nobody)
        info.warnings.push_back(
            fmt::format("cannot tell which tablet {} is, and takes it for {}: {}", info.name,
                        tablet_name(*match), identified.error().message));
    else
        warn(read_strings(info, port, setup.strings));
    if (switched_by == SwitchedBy::Kernel)
        return;
    warn(send_all(port, &TabletPort::send_feature, setup.feature_reports));
    warn(send_all(port, &TabletPort::send_output, setup.output_reports));
}

} // namespace tractus::drivers
