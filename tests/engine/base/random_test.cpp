#include "engine/base/random.h"

#include "engine/base/random_blocks.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus {
namespace {

// Known answers for philox4x32 with 10 rounds, published with the reference implementation
// (Random123, kat_vectors).
TEST(Random, GivesTheWordsOfPhilox)
{
    EXPECT_EQ(random_block({}, 0),
              (std::array<std::uint32_t, 4> { 0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8 }));
    EXPECT_EQ(random_block({ 0xffffffffffffffff, 0xffffffff, 0xffffffff }, 0xffffffffffffffff),
              (std::array<std::uint32_t, 4> { 0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd }));
}

TEST(Random, GivesSeveralBlocksAsItGivesEach)
{
    std::uint64_t const seed = 0x123456789abcdef0;
    RandomBlocks::Words const substreams { 0, 1, 2, 3, 0xffffffff, 70'000, 6, 0x80000000 };
    RandomBlocks::Words const indices { 5, 0xffffffff, 0, 1, 2, 3, 0x80000000, 9 };
    auto const blocks = random_blocks(seed, 77, substreams, indices);
    for (std::size_t i = 0; i < RandomBlocks::kCount; ++i) {
        auto const block = random_block({ seed, 77, substreams[i] }, indices[i]);
        for (std::size_t word = 0; word < block.size(); ++word)
            EXPECT_EQ(blocks.words[word][i], block[word]);
    }
}

TEST(Random, ReadsTheBlocksInOrder)
{
    RandomKey const key { 7, 1, 2 };
    Random random(key);
    for (std::uint64_t block = 0; block < 3; ++block)
        for (auto const word : random_block(key, block))
            EXPECT_EQ(random.next_u32(), word);
}

TEST(Random, UniformStaysInItsRange)
{
    Random random({ 1, 0, 0 });
    double sum = 0;
    for (int i = 0; i < 10'000; ++i) {
        double const value = random.uniform(-2, 4);
        ASSERT_GE(value, -2);
        ASSERT_LT(value, 4);
        sum += value;
    }
    EXPECT_NEAR(sum / 10'000, 1, 0.06); // The standard error of the mean is 0.017.
}

TEST(Random, NormalHasMeanZeroAndVarianceOne)
{
    Random random({ 1, 0, 0 });
    double sum = 0;
    double squares = 0;
    constexpr int kCount = 40'000;
    for (int i = 0; i < kCount; ++i) {
        double const value = random.normal();
        sum += value;
        squares += value * value;
    }
    EXPECT_NEAR(sum / kCount, 0, 0.02);     // The standard error of the mean is 0.005.
    EXPECT_NEAR(squares / kCount, 1, 0.03); // The standard error of the mean square is 0.007.
}

TEST(Random, StreamsWithDifferentKeysDiffer)
{
    EXPECT_NE(random_block({ 1, 0, 0 }, 0), random_block({ 2, 0, 0 }, 0));
    EXPECT_NE(random_block({ 1, 0, 0 }, 0), random_block({ 1, 1, 0 }, 0));
    EXPECT_NE(random_block({ 1, 0, 0 }, 0), random_block({ 1, 0, 1 }, 0));
}

} // namespace
} // namespace tractus
