#include "app/verbs/devices.h"

#include "app/console.h"
#include "drivers/device_kind.h"
#include "drivers/hid_source.h"

#include <fmt/core.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tractus {

namespace {

// A device of this machine; `problem` says why it cannot be opened and is empty if it can.
struct Found {
    DeviceInfo info;
    DeviceDescription description;
    std::string problem;
};

std::vector<Found> find_devices()
{
    std::vector<Found> found;
    for (auto const& info : enumerate_hid()) {
        auto const source = open_hid(info);
        found.push_back({ info, describe_device(info), source ? "" : source.error().message });
    }
    return found;
}

char const* name_of(DeviceKind kind)
{
    switch (kind) {
    case DeviceKind::Pen:
        return "pen";
    case DeviceKind::Height:
        return "height";
    case DeviceKind::Other:
        return "other";
    }
    return "other";
}

std::string as_json_text(std::vector<Found> const& devices)
{
    auto list = nlohmann::json::array();
    for (auto const& [info, description, problem] : devices)
        list.push_back({ { "node", info.location },
                         { "name", info.name },
                         { "bus", info.bus },
                         { "vendor_id", fmt::format("{:04x}", info.vendor_id) },
                         { "product_id", fmt::format("{:04x}", info.product_id) },
                         { "kind", name_of(description.kind) },
                         { "description", description.text },
                         { "can_open", problem.empty() },
                         { "problem", problem } });
    // A device may call itself anything, in no encoding.
    return list.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string as_text(std::vector<Found> const& devices)
{
    std::string text;
    bool has_pen = false;
    for (auto const& [info, description, problem] : devices) {
        has_pen |= description.kind == DeviceKind::Pen;
        text += fmt::format("{}  {} ({:04x}:{:04x})\n    {}\n", info.location, info.name,
                            info.vendor_id, info.product_id, description.text);
        text += fmt::format("    {}\n", problem.empty() ? "can be opened" : problem);
    }
    if (!has_pen)
        text += fmt::format(
            "{} Nothing is lost: without hardware, tractus runs on a simulated tablet and "
            "height sensor.\n",
            devices.empty() ? "No HID device is plugged in." : "None of these is a pen tablet.");
    return text;
}

} // namespace

void add_devices_verb(CLI::App& root, Action& action)
{
    auto* const verb
        = root.add_subcommand("devices", "List pen tablets, height sensors and other HID devices");
    verb->footer(
        "For each hidraw node: its name and ids, what its report descriptor says it is, and\n"
        "whether it can be opened, or why not.");
    auto as_json = std::make_shared<bool>(false); // Shared by the parser's flag and the action.
    verb->add_flag("--json", *as_json, "Print a JSON array");
    verb->callback([&action, as_json] {
        action = [as_json]() -> Result<void> {
            auto const devices = find_devices();
            return print_out(*as_json ? as_json_text(devices) : as_text(devices));
        };
    });
}

} // namespace tractus
