#pragma once

#include "drivers/gpio/quadrature.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <memory>
#include <string>
#include <vector>

namespace tractus {

// The edges of two input lines of a GPIO chip, as the kernel has stamped and numbered them, held
// for us alone. Called from one thread only. After an error the lines are dead.
class GpioEdges {
public:
    virtual ~GpioEdges() = default;

    // Appends the edges that are there, in their order, after waiting for the first at most
    // `timeout`. Fails, as the device's fault, when the chip has gone.
    virtual Result<void> read(Duration timeout, std::vector<QuadratureEdge>& edges) = 0;

    virtual Timestamp now() = 0; // Time by the clock of the edges' times.

    // Returns what the lines were before the first edge that is read.
    virtual Quadrature::Beginning beginning() const = 0;
};

// How many edges the kernel keeps for us; when more wait, the oldest are gone, and their numbers
// with them.
constexpr unsigned kGpioEdgesKept = 4096;

// Takes two lines of the chip with this name or label. By the kernel's own interface (linux/gpio.h,
// version 2, from kernel 5.10), since libgpiod 1.6 speaks version 1, in which edges have no
// numbers, so that lost ones go unnoticed.
//
// Fails, as the user's fault, if there is no such chip or line, it may not be opened, somebody else
// holds the line, or the chip tells no edges.
Result<std::unique_ptr<GpioEdges>> open_gpio_edges(std::string const& chip, unsigned a_line,
                                                   unsigned b_line);

} // namespace tractus
