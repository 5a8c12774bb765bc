#pragma once

namespace tractus::batch {

// Makes malloc return each large block to the system as soon as it is freed. Otherwise, because of
// fragmentation, a window that grows plants for hours would hold several times the memory it needs.
// The setting costs page faults, so batch jobs do not use it.
void return_large_blocks();

} // namespace tractus::batch
