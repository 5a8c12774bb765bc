#pragma once

#include "drivers/reports/device_info.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace tractus::sim {

// A Silicon Labs CP2112, a bridge from USB to I²C with eight GPIO lines, as its HID interface shows
// it (application note AN495): the feature reports that the kernel's hid-cp2112 uses, which makes a
// gpiochip of it with the label "cp2112_gpio". I²C is not there. No clock and no randomness.
class Cp2112Model {
public:
    static constexpr unsigned kLines = 8;

    // Wiring of the lines. Bits are lines.
    struct Wiring {
        // The host has set the lines that it drives to these levels; all others are 0.
        std::function<void(std::uint8_t levels)> driven {};
        // The levels of the lines that the host does not drive.
        std::function<std::uint8_t()> levels {};
    };

    explicit Cp2112Model(Wiring wiring);

    // Returns what the kernel sees: ids, name, and a report descriptor with these reports.
    static drivers::DeviceInfo info();

    // The feature report of an id; no value for one that is not there, and for the lines' levels
    // while readings fail.
    std::optional<std::vector<std::byte>> get_feature(std::uint8_t id) const;

    // False for a report that is not there or too short.
    bool set_feature(std::span<std::byte const> report);

    // Makes the device behave from now on as if its cable were bad: every reading of lines fails.
    void fail_readings() { is_failing_ = true; }

private:
    std::uint8_t read_lines() const;
    void drive();

    Wiring wiring_;
    std::array<std::byte, 5> configuration_ {}; // Report 2.
    std::array<std::byte, 14> bus_ {};          // Report 6, kept for the host.
    std::uint8_t latch_ = 0;                    // Levels that lines that are outputs are set to.
    bool is_failing_ = false;
};

} // namespace tractus::sim
