#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace tractus {

// Allocates a block of memory; throws std::bad_alloc if there is none. Large blocks ask the kernel
// for huge pages, which cuts the time of the first write to a third.
void* allocate_bulk(std::size_t bytes);
void free_bulk(void* memory, std::size_t bytes);

// The allocator of BulkVector.
template<typename Value> struct BulkAllocator {
    static_assert(std::is_trivially_destructible_v<Value>);
    static_assert(alignof(Value) <= alignof(std::max_align_t));
    using value_type = Value;

    BulkAllocator() = default;
    template<typename Other> BulkAllocator(BulkAllocator<Other> const&) { }

    Value* allocate(std::size_t count)
    {
        return static_cast<Value*>(allocate_bulk(count * sizeof(Value)));
    }
    void deallocate(Value* memory, std::size_t count) { free_bulk(memory, count * sizeof(Value)); }

    // Leaves numbers uninitialised: the caller must write every element that it adds.
    template<typename Other> void construct(Other* place)
    {
        ::new (static_cast<void*>(place)) Other;
    }
    template<typename Other, typename... Arguments>
    void construct(Other* place, Arguments&&... arguments)
    {
        ::new (static_cast<void*>(place)) Other(std::forward<Arguments>(arguments)...);
    }

    friend bool operator==(BulkAllocator const&, BulkAllocator const&) { return true; }
};

// A vector for large arrays of numbers that are written once and in full: resize() leaves new
// elements uninitialised, and large arrays use huge pages.
template<typename Value> using BulkVector = std::vector<Value, BulkAllocator<Value>>;

// Asks the kernel for huge pages for the part of `memory` that has not been written yet. Has no
// effect if that part is too small or the kernel has no huge pages.
void advise_huge_pages(void* memory, std::size_t bytes);

// Resizes an empty vector as resize() does, but asks for huge pages before the elements are
// written.
template<typename Value> void resize_empty(std::vector<Value>& vector, std::size_t size)
{
    vector.reserve(size);
    advise_huge_pages(vector.data(), vector.capacity() * sizeof(Value));
    vector.resize(size);
}

} // namespace tractus
