#include "engine/stroke/subdivision.h"

#include "tests/engine/stroke/strokes.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

TEST(Subdivision, CutsCornersAndKeepsTheEnds)
{
    std::vector<Vec3> const coarse { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 8, 4, 0 } };
    std::vector<Vec3> const fine { { 0, 0, 0 }, { 2, 0, 0 }, { 4, 1, 0 },
                                   { 4, 3, 0 }, { 6, 4, 0 }, { 8, 4, 0 } };
    EXPECT_EQ(subdivide(coarse), fine);
}

TEST(Subdivision, ComesBackWithoutLoss)
{
    for (int const count : { 3, 4, 5, 6, 9, 40 }) {
        auto const coarse = trembling(s_curve(count), 30);
        auto const back = reverse_subdivide(subdivide(coarse));
        ASSERT_EQ(back.size(), coarse.size());
        for (std::size_t i = 0; i < coarse.size(); ++i)
            EXPECT_LT((back[i] - coarse[i]).norm(), 1e-12) << count << " points, number " << i;
    }
}

TEST(Subdivision, ThreeRoundsComeBack)
{
    auto const coarse = trembling(s_curve(7), 30);
    auto back = subdivide(subdivide(subdivide(coarse)));
    EXPECT_EQ(back.size(), 42u);
    for (int round = 0; round < 3; ++round)
        back = reverse_subdivide(back);
    for (std::size_t i = 0; i < coarse.size(); ++i)
        EXPECT_LT((back[i] - coarse[i]).norm(), 1e-11);
}

TEST(Subdivision, ReverseKeepsTheEndsOfWhatIsNoCurve)
{
    auto const drawn = trembling(s_curve(34), 5);
    auto const coarse = reverse_subdivide(drawn);
    EXPECT_EQ(coarse.size(), 18u);
    EXPECT_EQ(coarse.front(), drawn.front());
    EXPECT_EQ(coarse.back(), drawn.back());
}

TEST(SubdivisionDeathTest, ReverseWantsAnEvenNumber)
{
    EXPECT_DEATH(reverse_subdivide(s_curve(5)), "CHECK");
}

} // namespace
} // namespace tractus
