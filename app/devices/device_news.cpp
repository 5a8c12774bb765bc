#include "app/devices/device_news.h"

#include "app/terminal/console.h"

#include <fmt/core.h>
#include <utility>

namespace tractus::devices {

static char const* describe(LiveDevices::State state)
{
    switch (state) {
    case LiveDevices::State::Connected:
        return "is back";
    case LiveDevices::State::Away:
        return "has gone: waiting for it to come back";
    case LiveDevices::State::Ended:
        return "is over";
    }
    return "";
}

void DeviceNews::tell(LiveDevices const& devices)
{
    for (std::size_t i = 0; i < told_.size(); ++i) {
        auto const state = devices.state(i);
        auto const refusal = devices.refusal(i);
        if (std::exchange(told_[i].state, state) != state)
            terminal::print_error(fmt::format("{} at {} {}\n", devices.infos()[i].name,
                                              devices.infos()[i].location, describe(state)));
        if (std::exchange(told_[i].refusal, refusal) != refusal && !refusal.empty())
            terminal::print_error(fmt::format("it is plugged in again, but {}\n", refusal));
    }
}

} // namespace tractus::devices
