#include "app/commands/devices.h"

#include "app/diagnosis/system_facts.h"
#include "app/terminal/console.h"

#include <cstring>
#include <fmt/core.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tractus::commands {

namespace {

char const* name_of(drivers::DeviceKind kind)
{
    switch (kind) {
    case drivers::DeviceKind::Pen:
        return "pen";
    case drivers::DeviceKind::Height:
        return "height";
    case drivers::DeviceKind::Other:
        return "other";
    }
    return "other";
}

std::string problem_of(diagnosis::DeviceFacts const& device)
{
    if (device.open_error == 0)
        return {};
    return fmt::format("cannot be opened: {} (\"tractus doctor\" says what to do)",
                       std::strerror(device.open_error));
}

std::string as_json_text(std::vector<diagnosis::DeviceFacts> const& devices)
{
    auto list = nlohmann::json::array();
    for (auto const& device : devices) {
        auto const& info = device.info;
        list.push_back({ { "node", info.location },
                         { "name", info.name },
                         { "bus", info.bus },
                         { "vendor_id", fmt::format("{:04x}", info.vendor_id) },
                         { "product_id", fmt::format("{:04x}", info.product_id) },
                         { "serial_number", info.serial_number },
                         { "interface", info.interface_number },
                         { "tablet", device.tablet },
                         { "family", device.family },
                         { "driver", device.driver },
                         { "kind", name_of(device.description.kind) },
                         { "description", device.description.text },
                         { "can_open", device.open_error == 0 },
                         { "problem", problem_of(device) } });
        if (device.poll_hz)
            list.back()["poll_hz"] = *device.poll_hz;
    }
    // Device names can contain any bytes; invalid UTF-8 is replaced.
    return list.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string as_text(std::vector<diagnosis::DeviceFacts> const& devices)
{
    std::string text;
    bool has_pen = false;
    for (auto const& device : devices) {
        auto const& info = device.info;
        has_pen |= device.description.kind == drivers::DeviceKind::Pen;
        text += fmt::format("{}  {} ({:04x}:{:04x})\n    {}\n", info.location, info.name,
                            info.vendor_id, info.product_id, device.description.text);
        if (!device.tablet.empty())
            text += fmt::format("    {}, reports as {}\n", device.tablet, device.family);
        if (device.poll_hz)
            text += fmt::format("    asked {:.0f} times a second at most\n", *device.poll_hz);
        if (!device.driver.empty())
            text += fmt::format("    the kernel's driver: {}\n", device.driver);
        text += fmt::format("    {}\n",
                            device.open_error == 0 ? "can be opened" : problem_of(device));
    }
    if (!has_pen)
        text += fmt::format(
            "{} \"tractus window\" draws with the mouse, whose wheel moves the surface; "
            "\"tractus draw --device simulated\" shows a simulated hand drawing.\n",
            devices.empty() ? "No HID device is plugged in." : "None of these is a pen tablet.");
    return text;
}

} // namespace

void add_devices_command(CLI::App& root, options::Action& action)
{
    auto* const command
        = root.add_subcommand("devices", "List pen tablets, height sensors and other HID devices");
    command->footer(
        "For each device: its node, which is its address for --device, its name and ids, what\n"
        "it is and how large, how often it is asked, and whether it can be opened, or why not.\n"
        "Converters on GPIO lines cannot be found: they are named by their address,\n"
        "gpio:CHIP:CLK,DIN,DOUT,CS:mcp3208:CHANNEL. Serial lines and channels of industrial\n"
        "I/O are listed, and read only where --device names them.");
    // Shared by the parser's flag and the command's action.
    auto as_json = std::make_shared<bool>(false);
    command->add_flag("--json", *as_json, "Print a JSON array");
    command->callback([&action, as_json] {
        action = [as_json]() -> Result<void> {
            auto const devices = diagnosis::gather_system_facts().devices;
            return terminal::print_out(*as_json ? as_json_text(devices) : as_text(devices));
        };
    });
}

} // namespace tractus::commands
