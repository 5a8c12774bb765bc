#pragma once

#include "engine/base/result.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace tractus::drivers {

// One line of a GPIO chip, as whoever drives it wants it.
struct GpioLine {
    enum class Direction { Input, Output };

    unsigned offset = 0; // Number on its chip, as gpioinfo counts.
    Direction direction = Direction::Input;
    bool initial = false; // State of an output when it is opened: high or low.
};

// A few lines of one GPIO chip, held for us alone. Values are bits: bit i is the line that was i-th
// when they were opened, 1 is high.
//
// A request to the kernel costs microseconds on a Raspberry Pi and a millisecond on a USB adapter,
// so all lines change in one. Called from one thread only. After an error the lines are dead.
class GpioLines {
public:
    static constexpr std::size_t kMaxLines = 32;

    virtual ~GpioLines() = default;

    // Makes the outputs what their bits say, all at once; bits of inputs are ignored. Fails, as the
    // device's fault, where the kernel tells: some chips' drivers, among them the CP2112's, swallow
    // a failing write. A failing get shows those a moment later.
    [[nodiscard]] virtual Result<void> set(std::uint32_t values) = 0;

    // Returns the levels of the inputs; bits of outputs are 0. Fails, as the device's fault, when
    // the chip has gone or does not answer.
    [[nodiscard]] virtual Result<std::uint32_t> get() = 0;
};

// Takes lines of the chip with this name ("gpiochip0") or label ("pinctrl-bcm2711"), through
// libgpiod, 1.6 or 2. The chip's name may change when it is plugged in again, its label does not.
//
// Fails, as the user's fault, if there is no such chip or line, it may not be opened, or somebody
// else holds the line.
Result<std::unique_ptr<GpioLines>> open_gpio_lines(std::string const& chip,
                                                   std::span<GpioLine const> lines);

// "1.6.3": the library's own word, for diagnosis.
std::string gpio_library_version();

} // namespace tractus::drivers
