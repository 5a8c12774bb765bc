#include "app/batch/malloc_tuning.h"

#include <malloc.h>

namespace tractus::batch {

void return_large_blocks()
{
#ifdef M_MMAP_THRESHOLD // Else the system's library has no such choice.
    // The library begins with that, too; once set it no longer grows with what is freed.
    constexpr int kLarge = 1 << 17;
    mallopt(M_MMAP_THRESHOLD, kLarge);
#endif
}

} // namespace tractus::batch
