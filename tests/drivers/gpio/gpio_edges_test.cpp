#include "drivers/gpio/gpio_edges.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

using namespace std::chrono_literals;

// Lines of a chip that reports the given edges at their times. Time advances only in read().
class ScriptedEdges final : public GpioEdges {
public:
    explicit ScriptedEdges(std::vector<QuadratureEdge> told)
        : told_(std::move(told))
    {
    }

    Result<void> read(Duration timeout, std::vector<QuadratureEdge>& edges) override
    {
        auto const end = now_ + timeout;
        if (next_ == told_.size() || told_[next_].time > end) {
            now_ = end;
            return {};
        }
        now_ = std::max(now_, told_[next_].time);
        edges.push_back(told_[next_++]);
        return {};
    }
    Timestamp now() override { return now_; }
    Quadrature::Beginning beginning() const override { return {}; }

private:
    std::vector<QuadratureEdge> told_;
    std::size_t next_ = 0;
    Timestamp now_ {};
};

QuadratureEdge edge(Duration since, QuadratureEdge::Line line, bool is_rising, unsigned number)
{
    return { .time = Timestamp() + since, .line = line, .is_rising = is_rising, .number = number };
}

constexpr auto kA = QuadratureEdge::Line::A;
constexpr auto kB = QuadratureEdge::Line::B;

Result<QuadratureLevels> both_high()
{
    return QuadratureLevels { .a = true, .b = true };
}

// Returns the encoder's state after all pending edges, counted from `beginning`.
Quadrature count_from(Quadrature::Beginning const& beginning, GpioEdges& edges)
{
    Quadrature quadrature(beginning);
    std::vector<QuadratureEdge> read;
    while (edges.now() < Timestamp() + 10s) {
        read.clear();
        EXPECT_TRUE(edges.read(1s, read));
        for (auto const& one : read)
            quadrature.push(one);
    }
    return quadrature;
}

// The kernel's driver of a CP2112 assumes both lines to be low before its first poll.
TEST(GpioEdges, TakeNoFirstLookAtHighLinesForEdges)
{
    ScriptedEdges edges(
        { edge(40ms, kA, true, 1), edge(40ms, kB, true, 2), edge(2s, kA, false, 3) });
    auto const beginning = find_beginning(edges, both_high, "cp2112_gpio");
    ASSERT_TRUE(beginning) << beginning.error().message;
    EXPECT_TRUE(beginning->a);
    EXPECT_TRUE(beginning->b);
    auto const quadrature = count_from(*beginning, edges);
    EXPECT_EQ(quadrature.lost_count(), 0u);
    EXPECT_EQ(quadrature.count(), 1);
}

TEST(GpioEdges, AreCountedFromTheFirstMomentOfRest)
{
    ScriptedEdges edges({ edge(99ms, kA, false, 1), edge(100500us, kB, false, 2),
                          edge(101100us, kA, true, 3), edge(3s, kB, true, 4) });
    auto const beginning = find_beginning(edges, both_high, "cp2112_gpio");
    ASSERT_TRUE(beginning) << beginning.error().message;
    EXPECT_EQ(beginning->number, 3u);
    EXPECT_GT(edges.now(), Timestamp() + 101100us);
}

TEST(GpioEdges, BeginNowhereWhileTheSurfaceMoves)
{
    std::vector<QuadratureEdge> told;
    for (unsigned i = 1; i < 2000; ++i)
        told.push_back(edge(i * 500us, i % 2 == 1 ? kA : kB, i % 4 < 2, i));
    ScriptedEdges edges(std::move(told));
    auto const beginning = find_beginning(edges, both_high, "gpiochip0");
    ASSERT_FALSE(beginning);
    EXPECT_EQ(beginning.error().fault, Fault::User);
    EXPECT_EQ(beginning.error().message,
              "the encoder on the GPIO chip gpiochip0 moves: let it rest, so that its counting can "
              "begin");
}

} // namespace
} // namespace tractus::drivers
