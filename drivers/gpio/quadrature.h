#pragma once

#include "engine/base/time.h"

#include <array>
#include <cstdint>

namespace tractus::drivers {

// A change of one of an encoder's two lines, A and B, which are a quarter of a period apart.
struct QuadratureEdge {
    enum class Line { A, B };

    Timestamp time {}; // When the line changed, by the kernel's interrupt.
    Line line = Line::A;
    bool is_rising = false;
    std::uint32_t number = 0; // Counts both lines' edges since they were opened, from 1.
};

// Counts an encoder's edges, all four of a period: up while A is ahead of B, down while B is.
//
// An edge that is missing makes the count wrong for good, and is noticed: a gap in the numbers, or
// a line that rises though it is high already.
class Quadrature {
public:
    // Where it begins.
    struct Beginning {
        bool a = false;           // High.
        bool b = false;           // High.
        std::uint32_t number = 0; // Number of the last edge before the next.
    };
    explicit Quadrature(Beginning const& beginning)
        : is_high_ { beginning.a, beginning.b }
        , last_number_(beginning.number)
    {
    }

    void push(QuadratureEdge const& edge);

    std::int32_t count() const { return count_; } // Counts from 0.

    // How many edges are missing at least. Then `count` is no longer true.
    std::uint32_t lost_count() const { return lost_count_; }

private:
    std::array<bool, 2> is_high_;                 // Indexed by line.
    std::array<bool, 2> is_known_ { true, true }; // Likewise: whether is_high_ is what it says.
    std::uint32_t last_number_;
    std::int32_t count_ = 0;
    std::uint32_t lost_count_ = 0;
};

} // namespace tractus::drivers
