#include "engine/base/shared_list.h"

#include <gtest/gtest.h>
#include <numeric>

namespace tractus {
namespace {

SharedList<int> counted_to(int end)
{
    SharedList<int> list;
    for (int i = 0; i < end; ++i)
        list.push_back(i);
    return list;
}

TEST(SharedList, IsAListOfAnyLength)
{
    for (int const length : { 0, 1, 31, 32, 33, 64, 200 }) {
        std::vector<int> expected(static_cast<std::size_t>(length));
        std::iota(expected.begin(), expected.end(), 0);
        auto const list = counted_to(length);
        EXPECT_EQ(list.vector(), expected);
        EXPECT_EQ(list.size(), expected.size());
        EXPECT_EQ(list.empty(), expected.empty());
    }
}

TEST(SharedList, SharesWithACopyAllButWhatDiffers)
{
    auto const one = counted_to(100);
    auto other = one;
    other.replace(50, -1);
    other.push_back(100);
    EXPECT_EQ(one.vector(), counted_to(100).vector());
    EXPECT_EQ(other[50], -1);
    EXPECT_EQ(other.back(), 100);
    EXPECT_EQ(&other[0], &one[0]);
    EXPECT_NE(&other[51], &one[51]);
    EXPECT_EQ(&other[64], &one[64]);
}

TEST(SharedList, LosesAnyElement)
{
    for (std::size_t const index : { 0u, 31u, 32u, 63u, 69u }) {
        auto list = counted_to(70);
        auto expected = list.vector();
        list.erase({ index });
        expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(index));
        EXPECT_EQ(list.vector(), expected);
        list.push_back(7);
        EXPECT_EQ(list.back(), 7);
    }
}

// Compares lists with vectors, for lengths near multiples of a block's length (32) and for changed
// indices at the ends of blocks.
TEST(SharedList, ChangesManyElementsAtOnce)
{
    for (int const length : { 1, 31, 32, 33, 64, 100 })
        for (std::size_t const step : { 1u, 3u, 31u, 32u }) {
            auto const before = counted_to(length);
            auto list = before;
            auto expected = list.vector();
            std::vector<std::size_t> indices;
            std::vector<std::pair<std::size_t, int>> elements;
            for (std::size_t i = 0; i < expected.size(); i += step) {
                indices.push_back(i);
                elements.emplace_back(i, -static_cast<int>(i));
                expected[i] = -static_cast<int>(i);
            }
            list.replace(elements);
            EXPECT_EQ(list.vector(), expected);
            list.append({ 7, 8, 9 });
            expected.insert(expected.end(), { 7, 8, 9 });
            EXPECT_EQ(list.vector(), expected);
            list.erase(indices);
            for (auto i = indices.rbegin(); i != indices.rend(); ++i)
                expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(*i));
            EXPECT_EQ(list.vector(), expected);
            EXPECT_EQ(before.vector(), counted_to(length).vector()) << "copies stay";
        }
    SharedList<int> all = counted_to(40);
    all.append({});
    all.erase({});
    EXPECT_EQ(all.size(), 40u);
}

} // namespace
} // namespace tractus
