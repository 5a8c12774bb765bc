#pragma once

namespace tractus::batch {

// Makes malloc return large blocks to the system as soon as they are freed, from now on. Otherwise
// a window that grows plants for hours would hold several times the memory it needs, because of
// fragmentation. Costs page faults, so batch jobs do not use it.
void return_large_blocks();

} // namespace tractus::batch
