#pragma once

#include "drivers/gpio/quadrature.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tractus::drivers {

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

// Levels of an encoder's two lines, as the chip tells them when it is asked.
struct QuadratureLevels {
    bool a = false; // High.
    bool b = false; // High.
};

// How long edges are not believed after the lines were taken. A chip without interrupts is looked
// at by its driver every now and then, each 40 ms by the kernel's hid-cp2112, and the first look is
// compared with what was there when somebody else had the lines, or with lines that are low: a line
// that has been high all the time rises then.
constexpr Duration kGpioEdgesUntrue = std::chrono::milliseconds(100);

// Finds where counting begins on lines that have just been taken: once edges are believed, at a
// moment without any, at which the lines' levels are those after the last edge. Edges before it are
// lost on purpose. Fails, as the user's fault, where there is no such moment, for the surface
// moves; otherwise as edges and levels do.
Result<Quadrature::Beginning>
find_beginning(GpioEdges& edges, std::function<Result<QuadratureLevels>()> const& levels,
               std::string const& chip);

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

} // namespace tractus::drivers
