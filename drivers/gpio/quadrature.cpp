#include "drivers/gpio/quadrature.h"

#include <cstddef>

namespace tractus::drivers {

// Counts an edge. Its direction follows from the levels before it: an edge of A at equal levels, or
// of B at different levels, means that A leads.
void Quadrature::push(QuadratureEdge const& edge)
{
    auto& is_high = is_high_[static_cast<std::size_t>(edge.line)];
    // Unsigned 32-bit arithmetic, so numbers may wrap around.
    auto const missing = edge.number - last_number_ - 1;
    last_number_ = edge.number;
    if (missing > 0)
        is_known_ = { false, false }; // The lost edges can belong to either line.
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
