#pragma once

#include <cstddef>
#include <memory_resource>
#include <mutex>

namespace tractus {

// Bump allocator for data that several threads build and discard together. Allocations are
// consecutive, on huge pages where the system has them; all memory is freed when the arena is
// destroyed. Thread-safe.
class Arena : public std::pmr::memory_resource {
public:
    Arena();

private:
    class BulkMemory : public std::pmr::memory_resource {
        void* do_allocate(std::size_t bytes, std::size_t alignment) override;
        void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override;
        bool do_is_equal(std::pmr::memory_resource const& other) const noexcept override
        {
            return this == &other;
        }
    };

    void* do_allocate(std::size_t bytes, std::size_t alignment) override;
    void do_deallocate(void*, std::size_t, std::size_t) override { }
    bool do_is_equal(std::pmr::memory_resource const& other) const noexcept override
    {
        return this == &other;
    }

    std::mutex mutex_;
    BulkMemory memory_;
    std::pmr::monotonic_buffer_resource blocks_;
};

} // namespace tractus
