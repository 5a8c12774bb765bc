#pragma once

#include "engine/base/time.h"

#include <array>
#include <cstdint>

namespace tractus::drivers {

// A level change of one of an encoder's two lines, A and B, which are a quarter of a period apart
// in phase.
struct QuadratureEdge {
    enum class Line { A, B };

    Timestamp time {}; // Time of the kernel's interrupt.
    Line line = Line::A;
    bool is_rising = false;
    std::uint32_t number = 0; // Sequence number over both lines since they were opened, from 1.
};

// Counts all four edges per period of an encoder: up while A leads, down while B leads.
//
// A missing edge makes the count permanently wrong. It is detected by a gap in the numbers, or by a
// rising edge of a line that is high already.
class Quadrature {
public:
    // State from which counting starts.
    struct Beginning {
        bool a = false;           // Level of line A; true: high.
        bool b = false;           // Level of line B; true: high.
        std::uint32_t number = 0; // Number of the last edge before counting starts.
    };
    explicit Quadrature(Beginning const& beginning)
        : is_high_ { beginning.a, beginning.b }
        , last_number_(beginning.number)
    {
    }

    void push(QuadratureEdge const& edge);

    std::int32_t count() const { return count_; } // Present count, which starts at 0.

    // Lower bound on the number of missing edges. Unless it is 0, count() is wrong.
    std::uint32_t lost_count() const { return lost_count_; }

private:
    std::array<bool, 2> is_high_;                 // Level of each line, indexed by Line.
    std::array<bool, 2> is_known_ { true, true }; // Whether is_high_ is valid; indexed by line.
    std::uint32_t last_number_;
    std::int32_t count_ = 0;
    std::uint32_t lost_count_ = 0;
};

} // namespace tractus::drivers
