#include "app/window/mouse_queue.h"

#include <gtest/gtest.h>

namespace tractus::window {

namespace {

MouseMoment moment(float x, bool is_down)
{
    return { { x, 0 }, is_down };
}

std::vector<float> places(MouseQueue::Part const& part)
{
    std::vector<float> places;
    for (auto const& moment : part.path)
        places.push_back(moment.place_px.x);
    return places;
}

using Places = std::vector<float>;

TEST(MouseQueue, AClickOfOneFrameIsSeenInTwo)
{
    MouseQueue queue;
    queue.push(moment(1, false));
    queue.push(moment(1, true));
    queue.push(moment(2, false));
    queue.push(moment(9, false));

    auto const press = queue.take_part();
    EXPECT_EQ(places(press), (Places { 1, 1 }));
    ASSERT_TRUE(press.change);
    EXPECT_TRUE(press.change->is_down);
    EXPECT_EQ(press.change->place_px.x, 1);
    EXPECT_FALSE(queue.is_empty());

    auto const release = queue.take_part();
    EXPECT_EQ(places(release), (Places { 2, 9 }));
    ASSERT_TRUE(release.change);
    EXPECT_FALSE(release.change->is_down);
    EXPECT_EQ(release.change->place_px.x, 2) << "not where the mouse went afterwards";
    EXPECT_TRUE(queue.is_empty());
}

TEST(MouseQueue, InkFollowsThePressInItsFrame)
{
    MouseQueue queue;
    queue.push(moment(1, true));
    queue.push(moment(2, true));
    queue.push(moment(3, true));
    EXPECT_EQ(places(queue.take_part()), (Places { 1, 2, 3 }));
    queue.push(moment(4, true));
    auto const drawn = queue.take_part();
    EXPECT_EQ(places(drawn), (Places { 4 }));
    EXPECT_FALSE(drawn.change);
}

TEST(MouseQueue, HasNothingWhileTheMouseRests)
{
    MouseQueue queue;
    EXPECT_TRUE(queue.is_empty());
    auto const part = queue.take_part();
    EXPECT_TRUE(part.path.empty());
    EXPECT_FALSE(part.change);
}

} // namespace

} // namespace tractus::window
