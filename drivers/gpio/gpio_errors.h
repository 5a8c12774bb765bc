#pragma once

#include "drivers/gpio/gpio_lines.h"
#include "engine/base/result.h"

#include <span>
#include <string>

namespace tractus::drivers {

// Error messages for the errno values of both libgpiod versions.

// Returns the error for a chip that could not be opened.
tl::unexpected<Error> cannot_open_gpio_chip(std::string const& chip, int error_number);

// Returns the error for lines that could not be requested.
tl::unexpected<Error> cannot_take_gpio_lines(std::string const& chip,
                                             std::span<GpioLine const> lines, int error_number);

// Returns the error for requested lines that no longer respond.
tl::unexpected<Error> lost_gpio_lines(std::string const& chip, int error_number);

} // namespace tractus::drivers
