#include "app/window/card_grid.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <set>
#include <vector>

namespace tractus::window {
namespace {

std::vector<view::StartCards> groups_of(std::size_t recent)
{
    std::vector<view::StartCards> groups {
        { "An empty sheet", std::vector<view::StartCard>(3), {} }
    };
    if (recent > 0)
        groups.push_back({ "Recent", std::vector<view::StartCard>(recent), "Earlier" });
    groups.push_back({ "From a model", std::vector<view::StartCard>(14), {} });
    return groups;
}

struct Box {
    float left, top, right, bottom;

    bool overlaps(Box const& other) const
    {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

std::vector<Box> boxes_of(CardGrid const& grid)
{
    std::vector<Box> boxes;
    for (auto const& place : grid.places)
        boxes.push_back(
            { place.left, place.top, place.left + grid.card_width, place.top + grid.card_height });
    return boxes;
}

void check_grid(std::vector<view::StartCards> const& groups, float width, float scale)
{
    // Minimum size of a target for the pen, equal to theme::kButtonHeight_px.
    constexpr float kPenHits_px = 56;
    auto const grid = arrange_cards(groups, width, scale);
    std::set<std::pair<std::size_t, std::size_t>> shown;
    for (auto const& place : grid.places)
        EXPECT_TRUE(shown.emplace(place.group, place.card).second) << "twice";
    std::size_t count = 0;
    for (auto const& group : groups)
        count += group.cards.size();
    EXPECT_EQ(shown.size(), count);
    EXPECT_GE(grid.card_width, 120 * scale);
    EXPECT_GE(grid.card_height, 2 * kPenHits_px * scale);
    auto const boxes = boxes_of(grid);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_GE(boxes[i].left, 0);
        EXPECT_LE(boxes[i].right, width + 0.5f);
        EXPECT_LE(boxes[i].bottom, grid.height);
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
            EXPECT_FALSE(boxes[i].overlaps(boxes[j])) << i << " and " << j;
        // Each title is assumed to be a line of text, at least 20 pixels wide.
        for (auto const& title : grid.titles)
            EXPECT_FALSE(boxes[i].overlaps(
                { title.left, title.top, title.left + 20, title.top + 30 * scale }))
                << title.text;
    }
}

TEST(CardGrid, ShowsEveryCardOnceAndNoneOverAnother)
{
    for (float const width : { 480.0f, 600.0f, 760.0f, 960.0f, 1240.0f, 1560.0f, 1880.0f })
        for (float const scale : { 1.0f, 1.5f, 2.0f })
            for (std::size_t const recent : { 0u, 1u, 5u, 12u }) {
                SCOPED_TRACE(fmt::format("{} at {}, {} recent", width, scale, recent));
                check_grid(groups_of(recent), width * scale, scale);
            }
}

// Throughout the page, the left edges of the columns must be equal, and the gaps equal to within a
// pixel. The columns must fill the width.
TEST(CardGrid, HasColumnsOfOneWidthThroughout)
{
    auto const grid = arrange_cards(groups_of(12), 1560, 1);
    std::set<float> lefts;
    for (auto const& place : grid.places)
        lefts.insert(place.left);
    ASSERT_EQ(lefts.size(), 8u);
    EXPECT_NEAR(*lefts.rbegin() + grid.card_width, 1560, 1.5);
    float const step = *std::next(lefts.begin());
    std::size_t column = 0;
    for (float const left : lefts)
        EXPECT_NEAR(left, step * static_cast<float>(column++), 4);
}

TEST(CardGrid, ShowsTheNewestBesideTheEmptySheetAndTheOthersLast)
{
    auto const grid = arrange_cards(groups_of(12), 1560, 1);
    ASSERT_EQ(grid.titles.size(), 4u);
    EXPECT_EQ(grid.titles[1].text, "Recent");
    EXPECT_EQ(grid.titles[1].top, grid.titles[0].top);
    EXPECT_EQ(grid.titles[3].text, "Earlier");
    EXPECT_EQ(grid.places[3].top, grid.places[0].top);
    EXPECT_EQ(grid.places.back().group, 1u);
    EXPECT_EQ(grid.places.back().card, 11u);
    // The narrow window has three columns of cards.
    auto const narrow = arrange_cards(groups_of(12), 480, 1);
    EXPECT_GT(narrow.titles[1].top, narrow.places[2].top);
}

TEST(CardGrid, LeadsTheArrowsFromCardToCard)
{
    // Three cards, and then 14 in rows of three.
    auto const grid = arrange_cards(groups_of(0), 480, 1);
    EXPECT_EQ(neighbour(grid, 0, Direction::Left), 0u);
    EXPECT_EQ(neighbour(grid, 0, Direction::Right), 1u);
    EXPECT_EQ(neighbour(grid, 1, Direction::Down), 4u);
    EXPECT_EQ(neighbour(grid, 4, Direction::Up), 1u);
    EXPECT_EQ(neighbour(grid, 14, Direction::Down), 16u) << "the last row is shorter";
    EXPECT_EQ(neighbour(grid, 16, Direction::Right), 16u);
    EXPECT_EQ(neighbour(grid, 16, Direction::Down), 16u);
    EXPECT_EQ(neighbour({}, 3, Direction::Down), 0u);
}

} // namespace
} // namespace tractus::window
