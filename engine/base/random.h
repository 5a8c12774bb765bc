#pragma once

#include <array>
#include <cstdint>

namespace tractus {

// Identifies a random stream. Streams with different keys are independent, so the random numbers of
// a branch do not depend on evaluation order, on threads, or on edits elsewhere. Callers choose a
// key for each use (plant, branch, step) instead of sharing one generator.
struct RandomKey {
    std::uint64_t seed = 0;
    std::uint32_t stream = 0;    // Purpose of the numbers: a constant that the caller chooses.
    std::uint32_t substream = 0; // Number of the plant, branch or step that uses the numbers.
};

// Returns the four random words at position `index` of the stream `key`, by Philox4x32-10 (Salmon,
// Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC 2011). A pure function.
std::array<std::uint32_t, 4> random_block(RandomKey const& key, std::uint64_t index);

// Reads the words of a stream in sequence. A copy continues from the same position.
class Random {
public:
    explicit Random(RandomKey const& key)
        : key_(key)
    {
    }

    std::uint32_t next_u32();
    std::uint64_t next_u64();

    // Returns a number uniformly distributed in [0, 1), a multiple of 2^-53.
    double uniform();

    // Returns a number uniformly distributed in [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    // Returns a normally distributed number with mean 0 and standard deviation 1. The Box-Muller
    // method makes two such numbers from two uniform ones; the second is kept for the next call.
    double normal();

private:
    RandomKey key_;
    std::uint64_t index_ = 0;
    std::array<std::uint32_t, 4> block_ {};
    unsigned left_ = 0;
    double spare_normal_ = 0;
    bool has_spare_ = false;
};

} // namespace tractus
