#pragma once

#include <array>
#include <cstdint>

namespace tractus {

// Names a random stream. Streams with different keys are independent, so a branch's numbers do not
// depend on order, threads, or edits elsewhere: name what the numbers are for (plant, branch, step)
// and ask.
struct RandomKey {
    std::uint64_t seed = 0;
    std::uint32_t stream = 0;    // Purpose of the numbers: a constant of the caller.
    std::uint32_t substream = 0; // Plant, branch, … that they are for.
};

// Four random words for position `index` of the stream `key`: Philox4x32-10 (Salmon, Moraes, Dror,
// Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC 2011). A pure function.
std::array<std::uint32_t, 4> random_block(RandomKey const& key, std::uint64_t index);

// Reads a stream's words one after another. Copying it copies its position.
class Random {
public:
    explicit Random(RandomKey const& key)
        : key_(key)
    {
    }

    std::uint32_t next_u32();
    std::uint64_t next_u64();

    // [0, 1), in steps of 2^-53.
    double uniform();

    // [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    // Mean 0, standard deviation 1. Box and Muller's method: two uniforms each, the second half
    // kept for the next call.
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
