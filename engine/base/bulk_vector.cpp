#include "engine/base/bulk_vector.h"

#include <cstdint>
#include <sys/mman.h>
#include <unistd.h>

namespace tractus {

constexpr std::size_t kHugePageBytes = std::size_t { 2 } << 20;
constexpr std::size_t kLargeBytes = 2 * kHugePageBytes;

void advise_huge_pages(void* memory, std::size_t bytes)
{
    // Includes the small pages at both ends: if the block is a memory mapping of its own, its last
    // huge page would otherwise not lie inside the advised range.
    auto const page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    auto const address = reinterpret_cast<std::uintptr_t>(memory);
    auto const begin = address / page * page;
    auto const end = (address + bytes + page - 1) / page * page;
    if (bytes >= kHugePageBytes) // The kernel may ignore the advice, so a failure does no harm.
        ::madvise(static_cast<char*>(memory) - (address - begin), end - begin, MADV_HUGEPAGE);
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
    // The unsized form is used: clang 14 provides the sized one only with -fsized-deallocation.
    ::operator delete (memory, std::align_val_t { kHugePageBytes });
}

} // namespace tractus
