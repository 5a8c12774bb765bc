#pragma once

#include "drivers/gpio/quadrature.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tractus::drivers {

// Edges of two input lines of a GPIO chip, time-stamped and numbered by the kernel; the lines are
// held exclusively. Single-threaded. After an error the object is unusable.
class GpioEdges {
public:
    virtual ~GpioEdges() = default;

    // Appends all pending edges in order, waiting at most `timeout` for the first. Fails with a
    // device error if the chip is gone.
    virtual Result<void> read(Duration timeout, std::vector<QuadratureEdge>& edges) = 0;

    virtual Timestamp now() = 0; // The present time, on the clock of the edges.

    // Levels and edge number before the first edge that is read.
    virtual Quadrature::Beginning beginning() const = 0;
};

// Current levels of an encoder's two lines.
struct QuadratureLevels {
    bool a = false; // Level of line A; true: high.
    bool b = false; // Level of line B; true: high.
};

// Time after opening the lines during which edges are ignored. For a chip without interrupts the
// driver polls (hid-cp2112: every 40 ms), and the first poll is compared with the state left by a
// previous user or with low levels. A line that has been high all the time then produces a false
// rising edge.
constexpr Duration kGpioEdgesSettleTime = std::chrono::milliseconds(100);

// Determines the starting state for counting on newly opened lines: a quiet moment after the
// initial false edges, when the levels agree with the last edge. Earlier edges are discarded. Fails
// with a user error if there is no quiet moment because the surface moves. Also fails if reading
// `edges` or `levels` fails.
Result<Quadrature::Beginning>
find_beginning(GpioEdges& edges, std::function<Result<QuadratureLevels>()> const& levels,
               std::string const& chip);

// Size of the kernel's edge buffer. If more edges are pending, the oldest are lost, which leaves a
// gap in their numbers.
constexpr unsigned kGpioEdgesKept = 4096;

// Opens two lines of the chip with this name or label. Uses the kernel's interface directly
// (linux/gpio.h, version 2, since kernel 5.10): libgpiod 1.6 uses version 1, whose edges have no
// numbers, so that lost edges would go unnoticed.
//
// Fails with a user error if the chip or a line does not exist, may not be opened or is in use, or
// if the chip does not report edges.
Result<std::unique_ptr<GpioEdges>> open_gpio_edges(std::string const& chip, unsigned a_line,
                                                   unsigned b_line);

} // namespace tractus::drivers
