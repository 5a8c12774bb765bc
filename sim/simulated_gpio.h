#pragma once

#include "drivers/gpio/gpio_lines.h"
#include "sim/mcp3208_model.h"

#include <cstdint>
#include <map>
#include <optional>

namespace tractus::sim {

// The four lines of an MCP3008 or MCP3208, connected to the converter model, with simulated time.
// Each request takes some time, and pauses can be inserted as if the scheduler had interrupted the
// program. The lines have the order of mcp3208_lines(): CLK, DIN, DOUT, CS.
//
// No clock and no threads: time advances only by requests and waiting.
class SimulatedGpio final : public drivers::GpioLines {
public:
    struct Options {
        // Time that a request takes, by default as on a Raspberry Pi.
        Duration request_time = std::chrono::microseconds(2);
        bool dout_pull = false; // Level of DOUT while nothing drives it.

        // Pauses before requests, by the request's number from 0.
        std::map<std::uint64_t, Duration> pauses {};

        // Number of the request from which on the chip is unplugged.
        std::optional<std::uint64_t> gone_at {};
        // True: failed writes are not reported, as in the kernel's CP2112 driver.
        bool swallows_failing_sets = false;
    };

    // The model must outlive this object.
    SimulatedGpio(Mcp3208Model& model, Options options);

    Result<void> set(std::uint32_t values) override;
    Result<std::uint32_t> get() override;

    Timestamp now() const { return now_; }
    void sleep_until(Timestamp time);
    std::uint64_t requests() const { return requests_; }

private:
    // Advances the time by one request. Returns whether the chip is still there.
    bool begin_request();

    Mcp3208Model& model_;
    Options options_;
    Timestamp now_ {};
    std::uint64_t requests_ = 0;
};

} // namespace tractus::sim
