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

// A Silicon Labs CP2112, a bridge from USB to I²C with eight GPIO lines, as seen through its HID
// interface (application note AN495). It has the feature reports that the kernel's hid-cp2112 uses
// to make a gpiochip with the label "cp2112_gpio". The reports of its I²C bus are in its report
// descriptor, but cp2112_bus.h processes them. No clock and no randomness are used.
class Cp2112Model {
public:
    static constexpr unsigned kLines = 8;

    // Connections of the lines; one bit for each line.
    struct Wiring {
        // Called when the host has set the lines that it drives to these levels; the bits of other
        // lines are 0.
        std::function<void(std::uint8_t levels)> driven {};
        // Returns the levels of the lines that the host does not drive.
        std::function<std::uint8_t()> levels {};
    };

    explicit Cp2112Model(Wiring wiring);

    // Returns the device as the kernel sees it: ids, name, and a report descriptor with the
    // CP2112's feature reports and those of its bus.
    static drivers::DeviceInfo info();

    // Returns a feature report; no value for an unknown id, or for the lines' levels while readings
    // fail.
    std::optional<std::vector<std::byte>> get_feature(std::uint8_t id) const;

    // Sets a feature report. Returns false if it is unknown or too short.
    bool set_feature(std::span<std::byte const> report);

    // Simulates a bad cable from now on: every reading of lines fails.
    void fail_readings() { is_failing_ = true; }

private:
    std::uint8_t read_lines() const;
    void drive();

    Wiring wiring_;
    std::array<std::byte, 5> configuration_ {}; // Content of report 2.
    std::array<std::byte, 14> bus_ {};          // Content of report 6, stored for the host.
    std::uint8_t latch_ = 0;                    // Levels to which output lines are set.
    bool is_failing_ = false;
};

} // namespace tractus::sim
