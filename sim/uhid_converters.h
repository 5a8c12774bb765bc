#pragma once

#include "engine/base/result.h"
#include "sim/cp2112_bus.h"
#include "sim/cp2112_model.h"
#include "sim/linak_desk_model.h"
#include "sim/mcp2221a_model.h"
#include "sim/mcp3208_model.h"
#include "sim/mcp3421_model.h"
#include "sim/simulated_encoder.h"
#include "sim/uhid_device.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace tractus::sim {

// Converters emulated through uhid. The kernel and all programs treat them as real devices.

// Returns the present input of a converter as a fraction of full scale, 0 to 1.
using InputNow = std::function<double()>;

// Emulates an MCP2221A. Each of its inputs GP1 to GP3 has the value `input()`, read anew for each
// command. Fails like UhidDevice::create().
Result<std::unique_ptr<UhidDevice>> play_mcp2221a(InputNow input);

// Emulates a standing desk. Its height is `input()` as a fraction of the decoder's full scale
// (drivers/sensors/linak_desk.h), read anew for each request. `on_move_command` is called for each
// command to move. Fails like UhidDevice::create().
Result<std::unique_ptr<UhidDevice>> play_linak_desk(InputNow input,
                                                    std::function<void()> on_move_command);

// An emulated MCP3208 connected to lines of a CP2112, which the kernel's hid-cp2112 exposes as a
// gpiochip.
class Cp2112WithMcp3208 {
public:
    struct Wiring {
        unsigned clk = 0;
        unsigned din = 1;
        unsigned dout = 2;
        unsigned cs = 3;
    };

    // `input` returns the present input of a channel, 0 to 7.
    Cp2112WithMcp3208(Wiring const& wiring, std::function<double(unsigned channel)> input);

    Cp2112WithMcp3208(Cp2112WithMcp3208 const&) = delete;
    Cp2112WithMcp3208& operator=(Cp2112WithMcp3208 const&) = delete;

    // Creates the device, which this object must outlive. Fails like UhidDevice::create().
    Result<std::unique_ptr<UhidDevice>> play();

    // Makes all readings of lines fail from now on.
    void fail_readings() { bridge_.fail_readings(); }

private:
    void drive(std::uint8_t levels);
    std::uint8_t levels() const;

    Wiring wiring_;
    Mcp3208Model converter_;
    Cp2112Model bridge_;
};

// An emulated MCP3421 on the I²C bus of a CP2112. The kernel's hid-cp2112 provides the bus. If the
// kernel is told of the chip, its driver mcp3422 makes it an industrial I/O device.
class Cp2112WithMcp3421 {
public:
    // `input` is read anew for each reading.
    explicit Cp2112WithMcp3421(InputNow input);

    Cp2112WithMcp3421(Cp2112WithMcp3421 const&) = delete;
    Cp2112WithMcp3421& operator=(Cp2112WithMcp3421 const&) = delete;

    // Creates the device, which this object must outlive. Fails like UhidDevice::create().
    Result<std::unique_ptr<UhidDevice>> play();

private:
    Mcp3421Model converter_;
    Cp2112Model bridge_;
    Cp2112Bus bus_;
};

// A quadrature encoder connected to two lines of a CP2112. The kernel polls the lines every ten
// ticks of its clock, 40 ms in Debian's kernel, and reports the edges that it finds; the encoder
// therefore moves by at most one count between polls. The encoder begins where both lines are low,
// the state that the kernel assumes before its first poll. Otherwise the kernel would report edges
// that did not occur.
class Cp2112WithEncoder {
public:
    struct Wiring {
        unsigned a = 0;
        unsigned b = 1;
    };

    // `target` returns the count to which the encoder moves.
    Cp2112WithEncoder(Wiring const& wiring, std::function<std::int64_t()> target);

    Cp2112WithEncoder(Cp2112WithEncoder const&) = delete;
    Cp2112WithEncoder& operator=(Cp2112WithEncoder const&) = delete;

    // Creates the device, which this object must outlive. Fails like UhidDevice::create().
    Result<std::unique_ptr<UhidDevice>> play();

private:
    std::uint8_t next_levels();

    Wiring wiring_;
    std::function<std::int64_t()> target_;
    std::int64_t begin_ = 0;               // Count at the first poll.
    std::optional<std::int64_t> count_ {}; // Present count; no value before the first poll.
    Cp2112Model bridge_;
};

} // namespace tractus::sim
