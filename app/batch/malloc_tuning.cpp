#include "app/batch/malloc_tuning.h"

#include <malloc.h>

namespace tractus::batch {

void keep_freed_memory()
{
#ifdef M_MMAP_THRESHOLD // Specific to glibc, as are the other two.
    // Larger blocks are mappings of their own, which free() returns at once: they would tear large
    // holes into the memory that is kept. Setting it also stops glibc from changing it by itself.
    constexpr int kVeryLarge = 8 << 20;
    mallopt(M_MMAP_THRESHOLD, kVeryLarge);
    // Free memory at the end of a heap, beyond which free() returns it.
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    // By how much more than needed a heap grows and shrinks. Heaps of threads, which have 64 MiB at
    // most, are given up only if the one before has so much room.
    mallopt(M_TOP_PAD, 1 << 20);
#endif
}

void return_freed_memory()
{
#ifdef M_MMAP_THRESHOLD
    malloc_trim(0);
#endif
}

} // namespace tractus::batch
