#pragma once

namespace tractus::batch {

// The memory of a window in which plants grow for hours. With another C library than glibc, these
// functions do nothing.

// Makes malloc keep what is freed, except for very large blocks, so that the next stroke's plant
// uses the same memory. Memory that comes anew from the system costs a page fault for every 4 KiB:
// hundreds a second while somebody draws.
void keep_freed_memory();

// Returns all memory that malloc keeps to the system. Meant for pauses: otherwise, because of
// fragmentation, a window that stands open for hours would hold several times the memory it needs.
void return_freed_memory();

} // namespace tractus::batch
