#include "app/tools/min_extent.h"

#include "app/methods/all_methods.h"
#include "app/tools/draw_tool.h"
#include "app/tools/select_tool.h"

#include <gtest/gtest.h>
#include <string>

namespace tractus::tools {
namespace {

Stroke through(std::initializer_list<Vec3> places)
{
    Stroke stroke;
    for (auto const& place : places)
        stroke.tips.push_back({ .position_mm = place });
    return stroke;
}

TEST(MinExtent, IsHowFarTheHandGetsFromWhereItBegan)
{
    EXPECT_EQ(extent_mm({}), 0);
    EXPECT_EQ(extent_mm(through({ { 1, 2, 3 } })), 0);
    EXPECT_EQ(extent_mm(through({ { 0, 0, 0 }, { 3, 4, 0 }, { 0, 0, 0 } })), 5) << "a loop";
    EXPECT_EQ(extent_mm(through({ { 0, 0, 100 }, { 0, 0, 300 } })), 200) << "a vertical line";
    Stroke tremor; // The extent of a stroke does not grow with the length of its path.
    for (int i = 0; i < 1000; ++i)
        tremor.tips.push_back({ .position_mm = { i % 2 * 0.5, 0, 0 } });
    EXPECT_EQ(extent_mm(tremor), 0.5);
}

TEST(MinExtent, IsReadAndWrittenAsWords)
{
    auto const usual = usual_min_extents(methods::all_methods().tools);
    EXPECT_EQ(parse_min_extents(print_min_extents(usual)).value(), usual);
    EXPECT_TRUE(parse_min_extents("").value().empty());
    EXPECT_EQ(parse_min_extents(" draw=2.5  indicate=0").value(),
              (MinExtents { { "draw", 2.5 }, { "indicate", 0 } }));
    for (auto const* const odd : { "draw", "=3", "draw=", "draw=x", "draw=-1", "draw=101",
                                   "draw=nan", "draw=inf", "draw=3mm", "dr\"aw=3", "dr\\aw=3" })
        EXPECT_FALSE(parse_min_extents(odd)) << odd;
}

TEST(MinExtent, IsNoneForToolsThatAreTouchedWith)
{
    auto const usual = usual_min_extents(methods::all_methods().tools);
    EXPECT_EQ(min_extent_mm(usual, SelectTool::kKind), 0);
    EXPECT_EQ(min_extent_mm(usual, DrawTool::kKind), 6);
    for (auto const* const kind : methods::all_methods().tools)
        if (kind->at_once || kind->surface == Surface::Skeleton) {
            EXPECT_EQ(min_extent_mm(usual, *kind), 0) << kind->word;
        }
}

} // namespace
} // namespace tractus::tools
