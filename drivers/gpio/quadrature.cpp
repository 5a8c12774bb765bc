#include "drivers/gpio/quadrature.h"

#include <cstddef>

namespace tractus::drivers {

// Before the edge A and B are equal or they are not; that, and whose edge it is, tells the
// direction: A's while they are equal, and B's while they are not, are those of A ahead.
void Quadrature::push(QuadratureEdge const& edge)
{
    auto& is_high = is_high_[static_cast<std::size_t>(edge.line)];
    // Counts 32 bits: numbers may begin anew at 0.
    auto const missing = edge.number - last_number_ - 1;
    last_number_ = edge.number;
    if (missing > 0)
        is_known_ = { false, false }; // Nobody knows whose edges they were.
    auto& is_known = is_known_[static_cast<std::size_t>(edge.line)];
    bool const rises_twice = is_known && is_high == edge.is_rising;
    lost_count_ += missing + (rises_twice ? 1 : 0);
    is_known = true;
    is_high = !edge.is_rising;
    bool const are_equal = is_high_[0] == is_high_[1];
    count_ += are_equal == (edge.line == QuadratureEdge::Line::A) ? 1 : -1;
    is_high = edge.is_rising;
}

} // namespace tractus::drivers
