#pragma once

#include "drivers/gpio/gpio_lines.h"
#include "sim/mcp3208_model.h"

#include <cstdint>
#include <map>
#include <optional>

namespace tractus::sim {

// The four lines of an MCP3008 or MCP3208 with the converter behind them, and the time that passes
// while somebody uses them: each request takes a while, and the scheduler may put a pause before
// any. The lines' order is that of mcp3208_lines: CLK, DIN, DOUT, CS.
//
// No clock and no threads: time is what the requests took and what was waited.
class SimulatedGpio final : public drivers::GpioLines {
public:
    struct Options {
        Duration request_time = std::chrono::microseconds(2); // A Raspberry Pi's.
        bool dout_pull = false; // Level that DOUT reads where nobody drives it.

        // Pauses, by the number of the request, from 0, before which they come.
        std::map<std::uint64_t, Duration> pauses {};

        // The request from which on the chip is gone: unplugged.
        std::optional<std::uint64_t> gone_at {};
        bool swallows_failing_sets = false; // As the kernel's driver of the CP2112 does.
    };

    // The model must outlive the lines.
    SimulatedGpio(Mcp3208Model& model, Options options);

    Result<void> set(std::uint32_t values) override;
    Result<std::uint32_t> get() override;

    Timestamp now() const { return now_; }
    void sleep_until(Timestamp time);
    std::uint64_t requests() const { return requests_; }

private:
    // Takes the time of one request, and says whether the chip is still there.
    bool begin_request();

    Mcp3208Model& model_;
    Options options_;
    Timestamp now_ {};
    std::uint64_t requests_ = 0;
};

} // namespace tractus::sim
