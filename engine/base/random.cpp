#include "engine/base/random.h"

#include "engine/base/random_blocks.h"
#include "engine/base/vectors.h"

#include <cmath>

namespace tractus {

// Multipliers and Weyl constants of Philox4x32, from the reference implementation of the paper.
constexpr std::uint64_t kMultiplier0 = 0xD2511F53;
constexpr std::uint64_t kMultiplier1 = 0xCD9E8D57;
constexpr std::uint32_t kWeyl0 = 0x9E3779B9;
constexpr std::uint32_t kWeyl1 = 0xBB67AE85;

std::array<std::uint32_t, 4> random_block(RandomKey const& key, std::uint64_t index)
{
    std::array<std::uint32_t, 4> counter { static_cast<std::uint32_t>(index),
                                           static_cast<std::uint32_t>(index >> 32), key.stream,
                                           key.substream };
    auto key0 = static_cast<std::uint32_t>(key.seed);
    auto key1 = static_cast<std::uint32_t>(key.seed >> 32);
    for (int round = 0; round < 10; ++round) {
        std::uint64_t const product0 = kMultiplier0 * counter[0];
        std::uint64_t const product1 = kMultiplier1 * counter[2];
        counter = { static_cast<std::uint32_t>(product1 >> 32) ^ counter[1] ^ key0,
                    static_cast<std::uint32_t>(product1),
                    static_cast<std::uint32_t>(product0 >> 32) ^ counter[3] ^ key1,
                    static_cast<std::uint32_t>(product0) };
        key0 += kWeyl0;
        key1 += kWeyl1;
    }
    return counter;
}

RandomBlocks random_blocks(std::uint64_t seed, std::uint32_t stream,
                           RandomBlocks::Words const& substreams,
                           RandomBlocks::Words const& indices)
{
    RandomBlocks blocks { { indices, {}, {}, substreams } };
    auto& [counter0, counter1, counter2, counter3] = blocks.words;
    counter2.fill(stream);
    auto key0 = static_cast<std::uint32_t>(seed);
    auto key1 = static_cast<std::uint32_t>(seed >> 32);
    for (int round = 0; round < 10; ++round) {
#pragma GCC unroll 1 // g++ does not vectorise this loop if it is fully unrolled.
        for (std::size_t i = 0; i < RandomBlocks::kCount; ++i) {
            std::uint64_t const product0 = kMultiplier0 * counter0[i];
            std::uint64_t const product1 = kMultiplier1 * counter2[i];
            counter0[i] = static_cast<std::uint32_t>(product1 >> 32) ^ counter1[i] ^ key0;
            counter1[i] = static_cast<std::uint32_t>(product1);
            counter2[i] = static_cast<std::uint32_t>(product0 >> 32) ^ counter3[i] ^ key1;
            counter3[i] = static_cast<std::uint32_t>(product0);
        }
        key0 += kWeyl0;
        key1 += kWeyl1;
    }
    return blocks;
}

std::uint32_t Random::next_u32()
{
    if (left_ == 0) {
        block_ = random_block(key_, index_++);
        left_ = 4;
    }
    return block_[4 - left_--];
}

std::uint64_t Random::next_u64()
{
    std::uint64_t const high = next_u32();
    return high << 32 | next_u32();
}

double Random::uniform()
{
    return static_cast<double>(next_u64() >> 11) * 0x1p-53;
}

double Random::normal()
{
    if (has_spare_) {
        has_spare_ = false;
        return spare_normal_;
    }
    double const radius = std::sqrt(-2 * std::log(1 - uniform()));
    double const angle = 2 * kPi * uniform();
    spare_normal_ = radius * std::sin(angle);
    has_spare_ = true;
    return radius * std::cos(angle);
}

} // namespace tractus
