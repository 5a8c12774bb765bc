#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace tractus {

// Memory for many bytes; throws std::bad_alloc if there is none. Large blocks ask the kernel for
// huge pages: to touch memory for the first time then takes a third of the time.
void* allocate_bulk(std::size_t bytes);
void free_bulk(void* memory, std::size_t bytes);

// Allocator that makes a std::vector a BulkVector.
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

    // Numbers stay unset: whoever makes room for them writes them.
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

// A vector for large arrays of numbers that are written once, all of them: resize() leaves new
// elements unset, and large arrays lie on huge pages.
template<typename Value> using BulkVector = std::vector<Value, BulkAllocator<Value>>;

// Asks the kernel for huge pages for what lies inside of memory that was not written yet. Without
// effect where that is too small, or the kernel has none.
void advise_huge_pages(void* memory, std::size_t bytes);

// Gives an empty vector its size, as resize() does, on huge pages.
template<typename Value> void resize_empty(std::vector<Value>& vector, std::size_t size)
{
    vector.reserve(size);
    advise_huge_pages(vector.data(), vector.capacity() * sizeof(Value));
    vector.resize(size);
}

} // namespace tractus
