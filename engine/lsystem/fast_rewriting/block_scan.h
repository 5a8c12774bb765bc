#pragma once

#include "engine/lsystem/language/model.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tractus::lsystem {

// Finds the modules of a part of a string that do not stay as they are.
class BlockScan {
public:
    // A part has at most so many modules.
    static constexpr std::size_t kMost = 2048;

    // Facts about a kind of modules.
    struct Kind {
        std::uint8_t parameter_count = 0;
        bool changes = false; // Other modules stay as they are.
        bool draws = false;   // Its first random number is needed beforehand.
    };
    using Kinds = std::array<Kind, 256>;

    // A module that changes.
    struct Change {
        std::uint32_t module = 0;    // Number of the module from the beginning of the part.
        std::uint32_t parameter = 0; // Where its parameters begin, likewise.
    };

    void find(Kinds const& kinds, std::span<KindId const> modules);
    // Makes the numbers of those changes that draw, where the part begins at module `begin`: the
    // first that VirtualMachine would give for each. Modules have numbers below 2^32.
    void draw(std::uint64_t seed, std::uint32_t step, std::size_t begin);

    // The changes that the last find() found, in order.
    std::span<Change const> changes() const { return { changes_.data(), count_ }; }
    std::uint32_t parameter_count() const { return parameter_count_; }
    // [0, 1) for a change that draws; for others anything.
    double number(std::size_t change) const { return numbers_[change]; }

private:
    std::size_t count_ = 0;
    std::uint32_t parameter_count_ = 0;
    std::size_t drawing_count_ = 0;
    std::array<Change, kMost + 1> changes_ {};
    std::array<double, kMost> numbers_ {};
    std::array<std::uint32_t, kMost + 1> drawing_ {}; // Numbers of the changes that draw.
};

} // namespace tractus::lsystem
