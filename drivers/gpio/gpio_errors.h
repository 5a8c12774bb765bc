#pragma once

#include "drivers/gpio/gpio_lines.h"
#include "engine/base/result.h"

#include <span>
#include <string>

namespace tractus::drivers {

// Messages for what both versions of libgpiod say in errno.

// Why a chip could not be opened.
tl::unexpected<Error> cannot_open_gpio_chip(std::string const& chip, int error_number);

// Why its lines could not be had.
tl::unexpected<Error> cannot_take_gpio_lines(std::string const& chip,
                                             std::span<GpioLine const> lines, int error_number);

// Why lines that we hold do not answer any more.
tl::unexpected<Error> lost_gpio_lines(std::string const& chip, int error_number);

} // namespace tractus::drivers
