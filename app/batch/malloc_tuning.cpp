#include "app/batch/malloc_tuning.h"

#include <malloc.h>

namespace tractus::batch {

void return_large_blocks()
{
#ifdef M_MMAP_THRESHOLD // M_MMAP_THRESHOLD is specific to glibc.
    // Equals glibc's initial threshold. Setting it explicitly stops glibc from raising it when
    // large blocks are freed.
    constexpr int kLarge = 1 << 17;
    mallopt(M_MMAP_THRESHOLD, kLarge);
#endif
}

} // namespace tractus::batch
