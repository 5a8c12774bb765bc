#include "engine/base/bulk_vector.h"

#include <cstdint>
#include <sys/mman.h>

namespace tractus {

constexpr std::size_t kHugePageBytes = std::size_t { 2 } << 20;
constexpr std::size_t kLargeBytes = 2 * kHugePageBytes;

void advise_huge_pages(void* memory, std::size_t bytes)
{
    auto const address = reinterpret_cast<std::uintptr_t>(memory);
    auto const begin = (address + kHugePageBytes - 1) / kHugePageBytes * kHugePageBytes;
    auto const end = (address + bytes) / kHugePageBytes * kHugePageBytes;
    if (begin < end) // Where the advice is not taken nothing is lost.
        ::madvise(static_cast<char*>(memory) + (begin - address), end - begin, MADV_HUGEPAGE);
}

void* allocate_bulk(std::size_t bytes)
{
    if (bytes < kLargeBytes)
        return ::operator new(bytes);
    auto* const memory = ::operator new (bytes, std::align_val_t { kHugePageBytes });
    advise_huge_pages(memory, bytes);
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
