#pragma once

#include "engine/base/bulk_vector.h"
#include "engine/lsystem/language/model.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <vector>

namespace tractus::lsystem {

// A growing array of trivially copyable values, for strings, which are large and are written once,
// in order. Unlike std::vector, it leaves new elements uninitialised and grows in place if the
// system can. Large arrays use huge pages.
template<typename T> class Column {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Column() = default;
    Column(Column const& other) { append(other.data(), other.size()); }
    Column(Column&& other) noexcept { swap(other); }
    Column& operator=(Column other) noexcept
    {
        swap(other);
        return *this;
    }
    ~Column() = default;

    void swap(Column& other) noexcept
    {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
    }

    std::size_t size() const { return size_; }
    std::size_t capacity() const { return capacity_; }
    bool empty() const { return size_ == 0; }
    T* data() { return data_.get(); }
    T const* data() const { return data_.get(); }
    T const& operator[](std::size_t index) const { return data_.get()[index]; }
    std::span<T const> span() const { return { data(), size_ }; }

    // Sets the size, which must not exceed the capacity; new elements are uninitialised.
    void set_size(std::size_t size) { size_ = size; }
    void clear() { size_ = 0; }
    void reserve(std::size_t capacity)
    {
        if (capacity <= capacity_)
            return;
        auto* const grown = std::realloc(data_.get(), capacity * sizeof(T));
        if (!grown)
            throw std::bad_alloc();
        static_cast<void>(data_.release()); // realloc() has freed or reused the old memory.
        data_.reset(static_cast<T*>(grown));
        capacity_ = capacity;
        advise_huge_pages(grown, capacity * sizeof(T));
    }
    // Makes room for `count` more elements.
    void reserve_more(std::size_t count)
    {
        if (size_ + count > capacity_)
            reserve(std::max(size_ + count, capacity_ + capacity_ / 2 + 64));
    }
    void append(T const* values, std::size_t count)
    {
        reserve_more(count);
        if (count > 0)
            std::memcpy(data() + size_, values, count * sizeof(T));
        size_ += count;
    }

private:
    struct Free {
        void operator()(T* data) const { std::free(data); }
    };
    std::unique_ptr<T, Free> data_;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

// State of the sub-L-system that one ?(...) of a string calls.
struct SubsystemCall {
    std::uint16_t subsystem = 0; // Index of the sub-L-system in Model::subsystems.
    bool has_started = false;    // True once the sub-L-system's Start block has run.
    std::vector<double> globals;
    std::vector<std::vector<double>> arrays;
};

// A module %(x) of a string, which cuts off the rest of its branch in the next step. The turtle
// that draws the part cut off then starts in the state ModuleString::turtles[turtle].
struct KeptCut {
    std::size_t module = 0;
    std::size_t turtle = 0;
};

// State of the turtle at a module %(x). In the plant's frame; lengths in turtle units.
struct CutTurtle {
    Vec3 position = Vec3::Zero();
    Vec3 heading = Vec3::UnitZ();
    Vec3 left = -Vec3::UnitX();
    Vec3 down = Vec3::UnitY();
    double width = 0;
    double scale = 1;
    double elasticity = 0;
    std::uint8_t color = 0;
};

// A string of modules: one byte for the kind of each module, and the parameters of all modules in
// sequence. Each module has as many parameters as its kind.
struct ModuleString {
    Column<KindId> kinds;
    Column<float> parameters;

    // Values of the main L-system's global variables and arrays after the last step, for use by
    // homomorphism rules.
    std::vector<double> globals;
    std::vector<std::vector<double>> arrays;
    // Calls of sub-L-systems: one for each ?(...) of the string, in order.
    std::vector<SubsystemCall> calls;
    std::vector<KeptCut> cuts; // Cuts in the order of their modules in the string.
    // Turtle states at cuts; after %(x,i) the turtle continues from state i.
    std::vector<CutTurtle> turtles;
    std::uint64_t seed = 0; // Seed of the random numbers in homomorphism rules.

    std::size_t size() const { return kinds.size(); }
    std::size_t byte_size() const
    {
        return kinds.size() * sizeof(KindId) + parameters.size() * sizeof(float);
    }

    // Enlarges the string to these sizes; new elements are uninitialised.
    void grow(std::size_t module_count, std::size_t parameter_count)
    {
        kinds.reserve_more(module_count - kinds.size());
        kinds.set_size(module_count);
        parameters.reserve_more(parameter_count - parameters.size());
        parameters.set_size(parameter_count);
    }
};

// Writes modules past the end of a string that has enough capacity. finish() then makes the written
// modules part of the string.
struct ModuleWriter {
    ModuleWriter(KindId* to_kinds, float* to_parameters)
        : kinds(to_kinds)
        , parameters(to_parameters)
    {
    }
    explicit ModuleWriter(ModuleString& string)
        : ModuleWriter(string.kinds.data() + string.kinds.size(),
                       string.parameters.data() + string.parameters.size())
    {
    }

    void finish(ModuleString& string) const
    {
        string.kinds.set_size(static_cast<std::size_t>(kinds - string.kinds.data()));
        string.parameters.set_size(static_cast<std::size_t>(parameters - string.parameters.data()));
    }

    KindId* kinds;
    float* parameters;
};

} // namespace tractus::lsystem
