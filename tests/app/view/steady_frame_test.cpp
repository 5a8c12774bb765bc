#include "app/view/steady_frame.h"

#include <gtest/gtest.h>
#include <set>

namespace tractus::view {
namespace {

TEST(SteadyFrame, IsEmptyWithoutAPoint)
{
    EXPECT_TRUE(SteadyFrame().box_mm().empty());
}

// A plant that grows to 250 mm, a millimetre at a time, always fits, fills more than half of the
// box once it is higher than its first height, and changes the box in few steps.
TEST(SteadyFrame, GrowsInFewSteps)
{
    SteadyFrame frame;
    std::set<double> tops;
    for (int z = 0; z <= 250; ++z) {
        frame.add(Vec3(3, 4, 10 + z));
        auto const box_mm = frame.box_mm();
        EXPECT_EQ(box_mm.min_mm.z(), 10);
        EXPECT_GE(box_mm.max_mm.z(), 10 + z);
        if (z > SteadyFrame::kFirstHeight_mm)
            EXPECT_LE(box_mm.max_mm.z() - 10, z * SteadyFrame::kStep + 1e-9);
        tops.insert(box_mm.max_mm.z());
    }
    EXPECT_LE(tops.size(), 5u);
}

// A plant that grows to one side makes room on that side alone.
TEST(SteadyFrame, KeepsTheOtherSides)
{
    SteadyFrame frame;
    frame.add(Vec3::Zero());
    auto const before_mm = frame.box_mm();
    frame.add(Vec3(-90, 0, 0));
    auto const after_mm = frame.box_mm();
    EXPECT_LE(after_mm.min_mm.x(), -90);
    EXPECT_EQ(after_mm.max_mm, before_mm.max_mm);
    EXPECT_EQ(after_mm.min_mm.y(), before_mm.min_mm.y());
    frame.add(Vec3(0, 0, -15));
    EXPECT_EQ(frame.box_mm().min_mm.z(), -15) << "below the first point";
}

TEST(SteadyFrame, CountsInItsUnit)
{
    SteadyFrame frame(20);
    frame.add(Vec3::Zero());
    EXPECT_EQ(frame.box_mm().max_mm.z(), 20 * SteadyFrame::kFirstHeight_mm);
}

} // namespace
} // namespace tractus::view
