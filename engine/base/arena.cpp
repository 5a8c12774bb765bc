#include "engine/base/arena.h"

#include "engine/base/bulk_vector.h"

namespace tractus {

// Size of the first block, in bytes. It is allocated on first use; later blocks are larger.
constexpr std::size_t kFirstBlock = std::size_t { 4 } << 20;

Arena::Arena()
    : blocks_(kFirstBlock, &memory_)
{
}

void* Arena::BulkMemory::do_allocate(std::size_t bytes, std::size_t)
{
    return allocate_bulk(bytes);
}

void Arena::BulkMemory::do_deallocate(void* memory, std::size_t bytes, std::size_t)
{
    free_bulk(memory, bytes);
}

void* Arena::do_allocate(std::size_t bytes, std::size_t alignment)
{
    std::lock_guard const lock(mutex_);
    return blocks_.allocate(bytes, alignment);
}

} // namespace tractus
