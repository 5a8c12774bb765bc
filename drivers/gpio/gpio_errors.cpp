#include "drivers/gpio/gpio_errors.h"

#include <cerrno>
#include <cstring>
#include <fmt/core.h>

namespace tractus::drivers {

tl::unexpected<Error> cannot_open_gpio_chip(std::string const& chip, int error_number)
{
    if (error_number == EACCES || error_number == EPERM)
        return fail(Fault::User,
                    fmt::format("cannot open the GPIO chip {}: permission denied (be in the group "
                                "gpio, or see what drivers/70-tractus.rules says of GPIO)",
                                chip));
    if (error_number == ENOENT || error_number == ENODEV || error_number == ENXIO)
        return fail(Fault::User,
                    fmt::format("there is no GPIO chip named or labelled {}: \"gpiodetect\" lists "
                                "those that there are",
                                chip));
    return fail(Fault::User,
                fmt::format("cannot open the GPIO chip {}: {}", chip, std::strerror(error_number)));
}

tl::unexpected<Error> cannot_take_gpio_lines(std::string const& chip,
                                             std::span<GpioLine const> lines, int error_number)
{
    std::string offsets;
    for (auto const& line : lines)
        offsets += fmt::format("{}{}", offsets.empty() ? "" : ",", line.offset);
    auto const what = fmt::format("cannot take the lines {} of the GPIO chip {}", offsets, chip);
    if (error_number == EBUSY)
        return fail(
            Fault::User,
            fmt::format("{}: one of them is in use; \"gpioinfo\" says by whom (SPI switched "
                        "on for the same pins, or the station running twice?)",
                        what));
    if (error_number == EINVAL)
        return fail(
            Fault::User,
            fmt::format("{}: the chip does not have them all, or one is named twice", what));
    return fail(Fault::User, fmt::format("{}: {}", what, std::strerror(error_number)));
}

tl::unexpected<Error> lost_gpio_lines(std::string const& chip, int error_number)
{
    return fail(Fault::Device,
                fmt::format("lost the lines of the GPIO chip {}: {} (was it unplugged?)", chip,
                            std::strerror(error_number)));
}

} // namespace tractus::drivers
