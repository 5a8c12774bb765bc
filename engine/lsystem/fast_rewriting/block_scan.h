#pragma once

#include "engine/lsystem/language/model.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tractus::lsystem {

// Finds the modules that rewriting changes in a part of a string.
class BlockScan {
public:
    // Maximum number of modules in a part.
    static constexpr std::size_t kMax = 2048;

    // Properties of a kind of module that the scan needs.
    struct Kind {
        std::uint8_t parameter_count = 0;
        bool changes = false; // True if rewriting can change modules of this kind.
        // True if a random number for each module of the kind is drawn in advance.
        bool draws = false;
    };
    using Kinds = std::array<Kind, 256>;

    // A module that rewriting changes.
    struct Change {
        std::uint32_t module = 0; // Index of the module, counted from the beginning of the part.
        // Index of the module's first parameter, counted from the beginning of the part.
        std::uint32_t parameter = 0;
    };

    void find(Kinds const& kinds, std::span<KindId const> modules);
    // Draws a random number for each change that needs one: the first number that VirtualMachine
    // would draw for that module. `begin` is the index in the string of the part's first module.
    // Module indices must be below 2^32.
    void draw(std::uint64_t seed, std::uint32_t step, std::size_t begin);

    // Returns the changes that the last find() found, in order.
    std::span<Change const> changes() const { return { changes_.data(), count_ }; }
    std::uint32_t parameter_count() const { return parameter_count_; }
    // Returns the random number in [0, 1) of a change that draws one; undefined for other changes.
    double number(std::size_t change) const { return numbers_[change]; }

private:
    std::size_t count_ = 0;
    std::uint32_t parameter_count_ = 0;
    std::size_t drawing_count_ = 0;
    std::array<Change, kMax + 1> changes_ {};
    std::array<double, kMax> numbers_ {};
    // Indices in changes_ of the changes that draw random numbers.
    std::array<std::uint32_t, kMax + 1> drawing_ {};
};

} // namespace tractus::lsystem
