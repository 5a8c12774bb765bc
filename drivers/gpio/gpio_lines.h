#pragma once

#include "engine/base/result.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace tractus::drivers {

// A requested line of a GPIO chip and its direction.
struct GpioLine {
    enum class Direction { Input, Output };

    unsigned offset = 0; // Number of the line on its chip, as listed by gpioinfo.
    Direction direction = Direction::Input;
    bool initial = false; // Level of an output on opening; true: high.
};

// Lines of one GPIO chip, held exclusively. Values are bit sets: bit i is the i-th line in the
// order of opening, 1 is high.
//
// All lines change in one kernel request, because a request takes microseconds on a Raspberry Pi
// but a millisecond on a USB adapter. Single-threaded. After an error the object is unusable.
class GpioLines {
public:
    static constexpr std::size_t kMaxLines = 32;

    virtual ~GpioLines() = default;

    // Sets all outputs at once; bits of inputs are ignored. Fails with a device error if the kernel
    // reports one. Some chips' drivers, such as the CP2112's, do not report failed writes; the next
    // get() fails then.
    [[nodiscard]] virtual Result<void> set(std::uint32_t values) = 0;

    // Levels of the inputs; bits of outputs are 0. Fails with a device error if the chip is gone or
    // does not answer.
    [[nodiscard]] virtual Result<std::uint32_t> get() = 0;
};

// Opens lines of the chip with this name ("gpiochip0") or label ("pinctrl-bcm2711") through
// libgpiod 1.6 or 2. A chip's name can change when it is plugged in again; its label does not.
//
// Fails with a user error if the chip or a line does not exist, may not be opened, or is in use.
Result<std::unique_ptr<GpioLines>> open_gpio_lines(std::string const& chip,
                                                   std::span<GpioLine const> lines);

// Version string of libgpiod, such as "1.6.3", for diagnosis.
std::string gpio_library_version();

} // namespace tractus::drivers
