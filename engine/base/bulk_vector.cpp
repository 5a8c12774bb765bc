#include "engine/base/bulk_vector.h"

#include <sys/mman.h>

namespace tractus {

constexpr std::size_t kHugePageBytes = std::size_t { 2 } << 20;
constexpr std::size_t kLargeBytes = 2 * kHugePageBytes;

void* allocate_bulk(std::size_t bytes)
{
    if (bytes < kLargeBytes)
        return ::operator new(bytes);
    auto* const memory = ::operator new (bytes, std::align_val_t { kHugePageBytes });
    ::madvise(memory, bytes, MADV_HUGEPAGE); // Advice: where it is not taken nothing is lost.
    return memory;
}

void free_bulk(void* memory, std::size_t bytes)
{
    if (bytes < kLargeBytes)
        return ::operator delete(memory);
    // Not by size, too: clang 14 has that only when asked for it.
    ::operator delete (memory, std::align_val_t { kHugePageBytes });
}

} // namespace tractus
