#include "calib/lowest_stop.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace tractus::calib {
namespace {

using namespace std::chrono_literals;

// A surface that a hand moves at 200 mm/s from one height to the next and leaves there.
class Moved {
public:
    // Moves the surface to a height and rests there for half a second. Returns true if a moved stop
    // was reported during this time.
    bool to(double height_mm)
    {
        bool is_told = through(height_mm);
        for (int i = 0; i < 250; ++i)
            is_told |= step(0);
        return is_told;
    }

    // As to(), but without a rest.
    bool through(double height_mm)
    {
        bool is_told = false;
        while (std::abs(height_mm - height_mm_) > kStep_mm)
            is_told |= step(height_mm > height_mm_ ? kStep_mm : -kStep_mm);
        return is_told | step(height_mm - height_mm_);
    }

    // Lets the surface down from 150 mm to a height several times, and returns how often a moved
    // stop was reported.
    int down_to(double height_mm, int times)
    {
        int told = 0;
        for (int i = 0; i < times; ++i) {
            told += to(150);
            told += to(height_mm);
        }
        return told;
    }

    LowestStop::Moved const& last() const { return last_; }

private:
    static constexpr double kStep_mm = 0.4;

    bool step(double by_mm)
    {
        height_mm_ += by_mm;
        time_ += 2ms;
        auto const moved = stop_.push(time_, height_mm_);
        last_ = moved.value_or(last_);
        return moved.has_value();
    }

    LowestStop stop_;
    LowestStop::Moved last_ {};
    Timestamp time_ {};
    double height_mm_ = 100;
};

TEST(LowestStop, HasMovedWhenTheSurfaceIsLetDownHigherAgainAndAgain)
{
    Moved surface;
    EXPECT_EQ(surface.down_to(20, 4), 0);
    EXPECT_EQ(surface.down_to(25, 3), 0) << "it may be held there";
    EXPECT_EQ(surface.down_to(25, 1), 1);
    EXPECT_NEAR(surface.last().from_mm, 20, 0.1);
    EXPECT_NEAR(surface.last().to_mm, 25, 0.1);
    EXPECT_EQ(surface.down_to(25, 10), 0) << "told once";
}

TEST(LowestStop, HasMovedWhenTheSurfaceGoesBelowIt)
{
    Moved surface;
    EXPECT_EQ(surface.down_to(20, 4), 0);
    EXPECT_EQ(surface.down_to(15, 1), 0);
    EXPECT_EQ(surface.down_to(15, 1), 1);
    EXPECT_NEAR(surface.last().to_mm - surface.last().from_mm, -5, 0.2);
}

TEST(LowestStop, IsKnownFromTurnsWithoutRest)
{
    Moved surface;
    for (double const height_mm : { 150, 20, 150, 20, 150, 20, 150, 20, 150, 15, 150, 15 })
        EXPECT_FALSE(surface.through(height_mm)) << height_mm;
    EXPECT_TRUE(surface.through(150)) << "it turned twice at 15 mm";
    EXPECT_NEAR(surface.last().to_mm - surface.last().from_mm, -5, 0.3);
}

TEST(LowestStop, IsWhereItWasAsLongAsTheSurfaceComesThere)
{
    Moved surface;
    EXPECT_EQ(surface.down_to(20, 4), 0);
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(surface.down_to(25, 3), 0);
        EXPECT_EQ(surface.down_to(20, 1), 0);
    }
}

TEST(LowestStop, IsNoneOfPlacesThatDiffer)
{
    Moved surface;
    int told = 0;
    for (double const height_mm : { 40.0, 31.0, 35.0, 22.0, 28.0, 20.0, 26.0, 24.0, 30.0, 21.0 })
        told += surface.down_to(height_mm, 1);
    EXPECT_EQ(told, 0);
    EXPECT_EQ(surface.down_to(25, 4), 0) << "20 was reached but once";
}

} // namespace
} // namespace tractus::calib
