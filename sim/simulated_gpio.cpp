#include "sim/simulated_gpio.h"

#include "drivers/gpio/mcp3208.h"

#include <algorithm>
#include <utility>

namespace tractus::sim {

namespace {

tl::unexpected<Error> gone()
{
    return fail(Fault::Device, "lost the lines of the simulated GPIO chip (was it unplugged?)");
}

} // namespace

SimulatedGpio::SimulatedGpio(Mcp3208Model& model, Options options)
    : model_(model)
    , options_(std::move(options))
{
}

bool SimulatedGpio::begin_request()
{
    auto const request = requests_++;
    if (auto const pause = options_.pauses.find(request); pause != options_.pauses.end())
        now_ += pause->second;
    now_ += options_.request_time;
    return !options_.gone_at || request < *options_.gone_at;
}

Result<void> SimulatedGpio::set(std::uint32_t values)
{
    if (!begin_request()) {
        if (options_.swallows_failing_sets)
            return {};
        return gone();
    }
    model_.set_pins(now_,
                    { .clk = (values & drivers::kMcp3208Clk) != 0,
                      .din = (values & drivers::kMcp3208Din) != 0,
                      .cs = (values & drivers::kMcp3208Cs) != 0 });
    return {};
}

Result<std::uint32_t> SimulatedGpio::get()
{
    if (!begin_request())
        return gone();
    return model_.dout().value_or(options_.dout_pull) ? drivers::kMcp3208Dout : 0;
}

void SimulatedGpio::sleep_until(Timestamp time)
{
    now_ = std::max(now_, time);
}

} // namespace tractus::sim
