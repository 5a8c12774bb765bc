#pragma once

namespace tractus::batch {

// Makes large blocks of memory go back to the system, from here on, as soon as they are freed. A
// window that grows plants for hours would else come to hold several times what it needs, in pieces
// that fit nothing. Costs what fresh pages cost, so what makes plant after plant does without.
void return_large_blocks();

} // namespace tractus::batch
