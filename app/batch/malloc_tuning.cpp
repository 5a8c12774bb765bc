#include "app/batch/malloc_tuning.h"

#include <malloc.h>

namespace tractus::batch {

void return_large_blocks()
{
#ifdef M_MMAP_THRESHOLD // Other C libraries have no such option.
    // This is glibc's initial threshold; setting it stops glibc from raising it when large blocks
    // are freed.
    constexpr int kLarge = 1 << 17;
    mallopt(M_MMAP_THRESHOLD, kLarge);
#endif
}

} // namespace tractus::batch
