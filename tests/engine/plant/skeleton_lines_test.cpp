#include "engine/plant/skeleton_lines.h"

#include "tests/engine/variation/plants.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

namespace tractus {
namespace {

// Returns the segments of a plant as separate lines in another order. Some of the lines are
// reversed.
std::vector<SkeletonPiece> pieces_of(Plant const& plant)
{
    std::vector<SkeletonPiece> pieces;
    for (auto const& axis : plant.axes)
        for (std::uint32_t i = 0; i < axis.segment_count; ++i)
            pieces.push_back({ plant.node_position_mm[axis.first_node + i],
                               plant.node_position_mm[axis.first_node + i + 1] });
    for (std::size_t i = 0; i < pieces.size(); i += 3)
        std::swap(pieces[i].from_mm, pieces[i].to_mm);
    std::reverse(pieces.begin(), pieces.end());
    return pieces;
}

TEST(SkeletonLines, BecomeThePlantThatTheyWereTakenFrom)
{
    auto const plant = variation::hand_made_plant();
    auto const found = plant_from_lines("x", pieces_of(plant));
    ASSERT_TRUE(found) << found.error().message;
    check_plant(*found);
    ASSERT_EQ(found->axes.size(), 4u);
    EXPECT_EQ(found->segment_count(), plant.segment_count());
    EXPECT_NEAR(axis_length_mm(*found, found->axes[0]), 400, 1e-9);
    std::vector<std::uint32_t> counts;
    for (auto const& axis : found->axes)
        counts.push_back(axis.segment_count);
    std::sort(counts.begin(), counts.end());
    EXPECT_EQ(counts, (std::vector<std::uint32_t> { 2, 2, 3, 4 }));
    EXPECT_EQ(found->axes.back().order, 2u);
    // By the pipe model, the trunk is thicker at its base.
    EXPECT_GT(found->node_radius_mm[0], found->node_radius_mm[4]);
}

TEST(SkeletonLines, OfALargeTreeAreJoinedWithinTheTolerance)
{
    auto const plant = variation::forking_tree(10, 4);
    auto pieces = pieces_of(plant);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        pieces[i].to_mm += 0.01 * Vec3(i % 2 ? 1 : -1, i % 3 ? 1 : -1, 0);
    auto const found = plant_from_lines("x", pieces).value();
    check_plant(found);
    EXPECT_EQ(found.segment_count(), plant.segment_count());
    EXPECT_EQ(std::count_if(found.axes.begin(), found.axes.end(),
                            [](Axis const& axis) { return axis.parent_axis == kNone; }),
              1);
}

TEST(SkeletonLines, CutALoopAndKeepPartsApart)
{
    std::vector<SkeletonPiece> const pieces {
        { { 0, 0, 0 }, { 0, 0, 10 } },    { { 0, 0, 10 }, { 5, 0, 20 } },
        { { 0, 0, 10 }, { -5, 0, 20 } },  { { 5, 0, 20 }, { 0, 0, 30 } },
        { { -5, 0, 20 }, { 0, 0, 30 } },  { { 90, 0, 3 }, { 90, 0, 13 } },
        { { 90, 0, 13 }, { 90, 0, 13 } }, // A line of zero length.
    };
    auto const plant = plant_from_lines("x", pieces).value();
    check_plant(plant);
    EXPECT_EQ(plant.segment_count(), 5u); // A loop of four lines is cut at one of them.
    EXPECT_EQ(std::count_if(plant.axes.begin(), plant.axes.end(),
                            [](Axis const& axis) { return axis.parent_axis == kNone; }),
              2);
}

TEST(SkeletonLines, AreRefusedWhereThereIsNoPlant)
{
    double const nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<SkeletonPiece> const broken { { { 0, 0, 0 }, { 0, nan, 1 } } };
    EXPECT_EQ(plant_from_lines("a.obj", broken).error().message,
              "a.obj: an end of line 1 is not a number: export the skeleton again");
    EXPECT_EQ(plant_from_lines("a.obj", {}).error().message,
              "a.obj: there is no line with a length that could be a branch");
}

TEST(ObjLines, AreReadYUpAndInMetres)
{
    auto const pieces = parse_obj_lines("a.obj",
                                        "# a plant\no skeleton\nv 0 0 0\nv 0 1 0\nv 0.5 1.5 0.25\n"
                                        "vn 0 1 0\nl 1 2 3\nl -3/1 -1\r\n");
    ASSERT_TRUE(pieces) << pieces.error().message;
    ASSERT_EQ(pieces->size(), 3u);
    EXPECT_EQ((*pieces)[0].to_mm, Vec3(0, 0, 1000));
    EXPECT_EQ((*pieces)[1].to_mm, Vec3(500, -250, 1500));
    EXPECT_EQ((*pieces)[2].from_mm, Vec3(0, 0, 0));
    auto const large = parse_obj_lines("a.obj", "v 0 0 0\nv 0 900 0\nl 1 2\n").value();
    // The coordinates are so large that they are read as millimetres.
    EXPECT_EQ(large[0].to_mm, Vec3(0, 0, 900));
}

TEST(ObjLines, SayWhatIsWrongAndWhere)
{
    auto const error
        = [](char const* text) { return parse_obj_lines("a.obj", text).error().message; };
    EXPECT_EQ(error("v 0 0 0\nl 1 2\n"), "a.obj:2: \"2\" is not one of the 1 vertices so far");
    EXPECT_EQ(error("v 0 zero 0\n"), "a.obj:1: \"zero\" is not a coordinate");
    EXPECT_EQ(error("v 0 0\n"), "a.obj:1: \"\" is not a coordinate");
    EXPECT_NE(error("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").find("as edges"), std::string::npos);
    EXPECT_NE(error("v 0 0 0\nl x 1\n").find("\"x\""), std::string::npos);
}

} // namespace
} // namespace tractus
