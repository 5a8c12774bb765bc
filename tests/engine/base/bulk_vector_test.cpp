#include "engine/base/bulk_vector.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <numeric>

namespace tractus {
namespace {

TEST(BulkVector, KeepsItsValuesAsItGrowsFromSmallToLarge)
{
    BulkVector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < 3'000'000; ++i) // The vector grows to 12 MB.
        numbers.push_back(i);
    BulkVector<std::uint32_t> const copy = numbers;
    std::uint32_t wrong = 0;
    for (std::uint32_t i = 0; i < numbers.size(); ++i)
        wrong += numbers[i] != i || copy[i] != i ? 1 : 0;
    EXPECT_EQ(wrong, 0u);
}

TEST(BulkVector, ALargeOneBeginsOnAHugePage)
{
    BulkVector<char> bytes(std::size_t { 5 } << 20);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(bytes.data()) % (std::size_t { 2 } << 20), 0u);
}

TEST(BulkVector, SetsValuesThatAreGiven)
{
    BulkVector<int> const numbers(1000, 7);
    EXPECT_EQ(std::accumulate(numbers.begin(), numbers.end(), 0), 7000);
}

} // namespace
} // namespace tractus
