#include "engine/plant/join_plants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace tractus {
namespace {

// Returns a stem of two segments with a branch, a leaf, a polygon, two materials and an organ
// shape.
Plant leafy_plant()
{
    Plant plant;
    plant.axes = { { .first_node = 0, .first_segment = 0, .segment_count = 2 },
                   { .first_node = 3,
                     .first_segment = 2,
                     .segment_count = 1,
                     .parent_segment = 0,
                     .parent_axis = 0,
                     .order = 1 } };
    plant.node_position_mm
        = { { 0, 0, 0 }, { 0, 0, 10 }, { 0, 0, 20 }, { 0, 0, 10 }, { 5, 0, 15 } };
    plant.node_radius_mm = { 2, 2, 1, 1, 1 };
    plant.segment_material = { 0, 1, 0 };
    plant.materials.resize(2);
    plant.organ_shapes = { { .name = "leaf", .material = 1 } };
    plant.organs = { { .shape = 0, .segment = 2, .position_mm = { 5, 0, 15 } } };
    plant.polygon_vertices_mm = { { 0, 0, 20 }, { 1, 0, 20 }, { 0, 1, 21 } };
    plant.polygons = { { .first_vertex = 0, .vertex_count = 3, .segment = 1, .material = 1 } };
    return plant;
}

TEST(JoinPlants, PutsOneBesideTheOther)
{
    auto plant = leafy_plant();
    append_plant(plant, leafy_plant(), { 100, 0, 0 });
    check_plant(plant);
    ASSERT_EQ(plant.axes.size(), 4u);
    EXPECT_EQ(plant.axes[2].parent_segment, kNone);
    EXPECT_EQ(plant.axes[3].parent_segment, 3u);
    EXPECT_EQ(plant.axes[3].parent_axis, 2u);
    EXPECT_EQ(plant.node_position_mm[9], Vec3(105, 0, 15));
    EXPECT_EQ(plant.segment_material, (std::vector<MaterialId> { 0, 1, 0, 2, 3, 2 }));
    EXPECT_EQ(plant.organs[1].shape, 1);
    EXPECT_EQ(plant.organs[1].segment, 5u);
    EXPECT_EQ(plant.organ_shapes[1].material, 3);
    EXPECT_EQ(plant.polygons[1].first_vertex, 3u);
    EXPECT_EQ(plant.polygons[1].material, 3);
    EXPECT_EQ(plant.polygon_vertices_mm[4], Vec3(101, 0, 20));
    EXPECT_TRUE(plant.node_section.empty());
}

TEST(JoinPlants, MakesRoundWhatHasNoSections)
{
    auto angular = leafy_plant();
    angular.contours = { { .name = "square", .points = std::vector<Vec3f>(Contour::kSteps + 1) } };
    angular.node_section.resize(5);
    angular.node_section[1] = { .contour = 0, .normal = Vec3f::UnitX() };
    auto before = leafy_plant();
    append_plant(before, angular, Vec3::Zero());
    ASSERT_EQ(before.node_section.size(), 10u);
    EXPECT_TRUE(before.node_section[1].is_round());
    EXPECT_EQ(before.node_section[6].contour, 0);
    auto behind = angular;
    append_plant(behind, angular, Vec3::Zero());
    append_plant(behind, leafy_plant(), Vec3::Zero());
    ASSERT_EQ(behind.node_section.size(), 15u);
    EXPECT_EQ(behind.node_section[6].contour, 1);
    EXPECT_TRUE(behind.node_section[11].is_round());
}

TEST(JoinPlants, PutsAPartOnABranch)
{
    auto plant = leafy_plant();
    // The part is rotated from +z to +x, and moved to 1 mm beside the end of segment 2.
    PartPlace const place { .on = 2,
                            .turn = Quat(Eigen::AngleAxisd(kPi / 2, Vec3::UnitY())),
                            .moved_mm = { 6, 0, 15 } };
    auto const segments = append_part(plant, leafy_plant(), place);
    check_plant(plant);
    EXPECT_EQ(segments, (std::vector<SegmentId> { 3, 4, 5 }));
    ASSERT_EQ(plant.axes.size(), 4u);
    EXPECT_EQ(plant.axes[2].parent_segment, 2u);
    EXPECT_EQ(plant.axes[2].parent_axis, 1u);
    EXPECT_EQ(plant.axes[2].order, 2u);
    EXPECT_EQ(plant.axes[3].parent_axis, 2u);
    EXPECT_EQ(plant.axes[3].order, 3u);
    EXPECT_EQ(plant.node_position_mm[5], Vec3(5, 0, 15)) << "at the branch's end";
    EXPECT_TRUE(plant.node_position_mm[6].isApprox(Vec3(16, 0, 15))) << "as the place says";
    EXPECT_TRUE(plant.node_position_mm[9].isApprox(Vec3(21, 0, 10)));
    EXPECT_TRUE((plant.organs[1].orientation * Vec3::UnitZ()).isApprox(Vec3::UnitX()));
}

TEST(JoinPlants, LeavesOutWhatIsHiddenAndWhatThatBears)
{
    Plant plant;
    auto const part = leafy_plant();
    EXPECT_EQ(append_part(plant, part, {}, { false, true, false }),
              (std::vector<SegmentId> { 0, kNone, 1 }));
    check_plant(plant);
    EXPECT_EQ(plant.axes.size(), 2u);
    EXPECT_EQ(plant.axes[0].segment_count, 1u);
    EXPECT_EQ(plant.organs.size(), 1u) << "on the branch";
    EXPECT_TRUE(plant.polygons.empty()) << "was on the upper segment";
    Plant none;
    EXPECT_EQ(append_part(none, part, {}, { true, false, false }),
              (std::vector<SegmentId>(3, kNone)));
    check_plant(none);
    EXPECT_TRUE(none.axes.empty());
    EXPECT_TRUE(none.organs.empty());
}

} // namespace
} // namespace tractus
