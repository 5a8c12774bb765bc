#include "app/commands/device_sources.h"

#include "app/terminal/console.h"
#include "app/terminal/error_text.h"

#include <csignal>
#include <fmt/core.h>

namespace tractus::commands {

static std::atomic<bool> stop_asked = false;

std::atomic<bool> const& stop_on_signals()
{
    auto const ask_to_stop = [](int) { stop_asked = true; };
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    // SIGHUP means that the terminal was closed. If it was already ignored, as after nohup, it
    // stays ignored.
    if (std::signal(SIGHUP, ask_to_stop) == SIG_IGN)
        std::signal(SIGHUP, SIG_IGN);
    return stop_asked;
}

static Result<devices::LiveDevices> open_named_or_found(std::vector<std::string> const& names,
                                                        std::string const& purpose)
{
    if (!names.empty())
        return devices::LiveDevices::open_named(names);
    auto const found = devices::find_pens_and_height_sensors();
    if (found.empty())
        return fail(Fault::User,
                    fmt::format("there is no tablet and no height sensor {}: \"tractus doctor\" "
                                "says why; the simulated rig goes by the name simulated",
                                purpose));
    return open_found(found);
}

Result<devices::LiveDevices> open_found(std::vector<drivers::DeviceInfo> const& found)
{
    std::vector<devices::RefusedDevice> refused;
    auto devices = devices::LiveDevices::open_usable(found, refused);
    if (devices.infos().empty() && !refused.empty())
        return tl::unexpected(refused.front().error);
    for (auto const& [info, error] : refused)
        terminal::print_error(fmt::format("without {}: {}\n", info.name, error.message));
    return devices;
}

Result<devices::LiveDevices> open_devices(std::vector<std::string> const& names,
                                          std::string const& purpose)
{
    auto devices = TRY(open_named_or_found(names, purpose));
    for (auto const& info : devices.infos())
        for (auto const& warning : info.warnings)
            terminal::print_warning(warning);
    return devices;
}

} // namespace tractus::commands
