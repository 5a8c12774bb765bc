#pragma once

#include "drivers/gpio/mcp3208.h"
#include "sim/mcp3208_model.h"
#include "sim/simulated_gpio.h"

#include <array>
#include <memory>
#include <utility>

namespace tractus::drivers {

// A converter with eight constant inputs, connected to simulated lines.
struct SimulatedConverter {
    std::array<double, 8> inputs {}; // Inputs as fractions of the reference.
    sim::Mcp3208Model model;
    sim::SimulatedGpio lines;

    explicit SimulatedConverter(sim::Mcp3208Model::Options const& model_options = {},
                                sim::SimulatedGpio::Options gpio_options = {})
        : model([this](unsigned channel, Timestamp) { return inputs.at(channel); }, model_options)
        , lines(model, std::move(gpio_options))
    {
    }
    SimulatedConverter(SimulatedConverter const&) = delete;
    SimulatedConverter& operator=(SimulatedConverter const&) = delete;

    Result<Mcp3208Reading> convert(Mcp3208Channel const& channel)
    {
        return convert_mcp3208(lines, channel, [this] { return lines.now(); });
    }
};

} // namespace tractus::drivers
