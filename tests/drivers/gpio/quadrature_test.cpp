#include "drivers/gpio/quadrature.h"

#include <gtest/gtest.h>
#include <string_view>

namespace tractus::drivers {
namespace {

// Returns the state after a sequence of edges. Each edge is written as a word: "A+" means that A
// rises; a lower-case letter, as in "b-", means that the edge was lost.
Quadrature after(std::string_view edges, Quadrature::Beginning const& beginning = {})
{
    Quadrature quadrature(beginning);
    auto number = beginning.number;
    for (std::size_t i = 0; i + 1 < edges.size(); i += 3) {
        ++number;
        bool const is_a = edges[i] == 'A' || edges[i] == 'a';
        if (edges[i] == 'A' || edges[i] == 'B')
            quadrature.push({ .line = is_a ? QuadratureEdge::Line::A : QuadratureEdge::Line::B,
                              .is_rising = edges[i + 1] == '+',
                              .number = number });
    }
    return quadrature;
}

TEST(Quadrature, CountsUpWhileAIsAhead)
{
    EXPECT_EQ(after("A+ B+ A- B-").count(), 4);
    EXPECT_EQ(after("A+ B+ A- B- A+ B+").count(), 6);
}

TEST(Quadrature, CountsDownWhileBIsAhead)
{
    EXPECT_EQ(after("B+ A+ B- A-").count(), -4);
}

TEST(Quadrature, TurnsRound)
{
    EXPECT_EQ(after("A+ B+ B- A-").count(), 0);
    EXPECT_EQ(after("A+ A- A+ A-").count(), 0); // The encoder trembles around one edge.
    EXPECT_EQ(after("A+ B+ A- A+ B- A-").count(), 0);
}

TEST(Quadrature, BeginsWhereverItIs)
{
    EXPECT_EQ(after("B- A+ B+", { .a = false, .b = true, .number = 7 }).count(), 3);
    EXPECT_EQ(after("B- A+ B+", { .a = false, .b = true, .number = 7 }).lost_count(), 0u);
}

TEST(Quadrature, NoticesEachLostEdgeByItsNumber)
{
    EXPECT_EQ(after("A+ B+ A- B-").lost_count(), 0u);
    EXPECT_EQ(after("A+ b+ A- B-").lost_count(), 1u);
    // The levels alone would not show this loss.
    EXPECT_EQ(after("A+ b+ a- b- A+").lost_count(), 3u);
}

TEST(Quadrature, NoticesALineThatRisesTwice)
{
    Quadrature quadrature({});
    quadrature.push({ .line = QuadratureEdge::Line::A, .is_rising = true, .number = 1 });
    quadrature.push({ .line = QuadratureEdge::Line::A, .is_rising = true, .number = 2 });
    EXPECT_EQ(quadrature.lost_count(), 1u);
}

TEST(Quadrature, GoesOnWhereNumbersBeginAnew)
{
    auto const quadrature = after("A+ B+", { .number = 0xffffffff });
    EXPECT_EQ(quadrature.count(), 2);
    EXPECT_EQ(quadrature.lost_count(), 0u);
}

} // namespace
} // namespace tractus::drivers
