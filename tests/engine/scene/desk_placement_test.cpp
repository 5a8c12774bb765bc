#include "engine/scene/desk_placement.h"

#include "tests/engine/plant/small_plant.h"

#include <gtest/gtest.h>

namespace tractus::scene {
namespace {

TEST(DeskPlacement, FitsAHighPlantToTheVolumesHeight)
{
    // The plant is 300 mm high and extends 100 mm to one side, so its height limits the scale.
    auto const placement = place_on_desk(small_plant(), { .width_mm = 250, .height_mm = 150 });
    EXPECT_DOUBLE_EQ(placement.scale, 0.5);
    EXPECT_DOUBLE_EQ(placement.shown_height_mm, 150);
    EXPECT_EQ(placement.world_of_plant({ 0, 0, 300 }), Vec3(0, 0, 150));
}

TEST(DeskPlacement, FitsAWidePlantToTheVolumesWidth)
{
    auto const placement = place_on_desk(small_plant(), { .width_mm = 50, .height_mm = 300 });
    // The plant extends 100 mm to the right, for which half of the width of 50 mm is available.
    EXPECT_DOUBLE_EQ(placement.scale, 0.25);
    EXPECT_DOUBLE_EQ(placement.shown_height_mm, 75);
}

TEST(DeskPlacement, GoesBackToThePlant)
{
    auto const placement = place_on_desk(small_plant());
    Vec3 const place(12, -7, 210);
    EXPECT_LT((placement.plant_of_world(placement.world_of_plant(place)) - place).norm(), 1e-12);
}

TEST(DeskPlacement, OfAnEmptyPlantIsNaturalSize)
{
    EXPECT_EQ(place_on_desk({}).scale, 1);
    EXPECT_GT(place_on_desk({}).shown_height_mm, 0);
}

TEST(SelectionView, ShowsTheWholePlantOnTheTabletFromTheFront)
{
    auto const plant = small_plant();
    DrawingVolume const volume { .width_mm = 254, .depth_mm = 159 };
    auto const view = fit_selection_view(plant);
    for (auto const& node : plant.node_position_mm) {
        auto const shown = view.tablet_of_plant(node);
        EXPECT_LT(std::abs(shown.x()), volume.width_mm / 2);
        EXPECT_LT(std::abs(shown.y()), volume.depth_mm / 2);
    }
    // A higher point of the plant is shown farther up on the tablet. The plant is shown in the
    // middle.
    EXPECT_GT(view.tablet_of_plant({ 0, 0, 300 }).y(), view.tablet_of_plant({ 0, 0, 0 }).y());
    EXPECT_NEAR(view.tablet_of_plant({ 50, 0, 150 }).norm(), 0, 1e-9);
}

// Returns a trunk with `laterals` axes of the first order. Each of them has one axis of the second
// order.
Plant bushy_plant(std::uint32_t laterals)
{
    Plant plant;
    plant.materials = { Material {} };
    auto const add = [&](SegmentId parent, AxisId parent_axis, std::uint32_t order) {
        plant.axes.push_back({ static_cast<NodeId>(plant.node_position_mm.size()),
                               static_cast<SegmentId>(plant.segment_count()), 1, parent,
                               parent_axis, order });
        plant.node_position_mm.insert(plant.node_position_mm.end(),
                                      { { 0, 0, 10. * order }, { 5, 0, 10. * order + 10 } });
        plant.node_radius_mm.insert(plant.node_radius_mm.end(), { 1, 1 });
        plant.segment_material.push_back(0);
    };
    add(kNone, kNone, 0);
    for (std::uint32_t i = 0; i < laterals; ++i) {
        add(0, 0, 1);
        add(static_cast<SegmentId>(plant.segment_count() - 1),
            static_cast<AxisId>(plant.axes.size() - 1), 2);
    }
    check_plant(plant);
    return plant;
}

TEST(SelectionView, ShowsAllOfASparsePlantAndTheFirstOrderOfADenseOne)
{
    EXPECT_EQ(fit_selection_view(bushy_plant(20)).max_order, 2u);
    EXPECT_EQ(fit_selection_view(bushy_plant(40)).max_order, 1u);
    EXPECT_EQ(fit_selection_view(bushy_plant(100)).max_order, 1u);
    auto const dense = bushy_plant(100);
    EXPECT_EQ(variation::ProjectedSkeleton(dense, skeleton_projection(fit_selection_view(dense)))
                  .lines()
                  .size(),
              101u);
}

TEST(SelectionView, ProjectsAsItShows)
{
    Vec3 const place(40, 25, 130);
    for (auto const& angle :
         { SelectionAngle {}, SelectionAngle { .azimuth_deg = 50, .elevation_deg = 20 } }) {
        auto const view = fit_selection_view(small_plant(), angle);
        auto const projection = skeleton_projection(view);
        Eigen::Vector4d const projected = projection.to_plane * place.homogeneous();
        EXPECT_LT((projected.head<2>() - view.tablet_of_plant(place)).norm(), 1e-12);
        Vec3 const nearer = place + 25 * view.back;
        EXPECT_GT(projected.z(), (projection.to_plane * nearer.homogeneous()).z());
        EXPECT_LT((view.tablet_of_plant(nearer) - projected.head<2>()).norm(), 1e-9);
    }
}

TEST(SelectionView, LooksFromWhereOneStands)
{
    // Seen from the right, points that are far from the user are on the right of the view.
    auto const plant = small_plant();
    auto const side = fit_selection_view(plant, { .azimuth_deg = 90 });
    EXPECT_GT(side.tablet_of_plant({ 0, 50, 0 }).x(), side.tablet_of_plant({ 0, -50, 0 }).x());
    // Seen from above, points on the far side are also farther up on the tablet.
    auto const high = fit_selection_view(plant, { .elevation_deg = 80 });
    EXPECT_GT(high.tablet_of_plant({ 0, 50, 0 }).y(), high.tablet_of_plant({ 0, -50, 0 }).y());

    SelectionAngle const small { .area_mm = { 150, 95 } };
    auto const on_small = fit_selection_view(plant, small);
    auto const twice
        = fit_selection_view(plant, { .zoom = 2, .moved_mm = { 5, -3 }, .area_mm = small.area_mm });
    for (auto const& node : plant.node_position_mm) {
        auto const shown = on_small.tablet_of_plant(node);
        EXPECT_TRUE((shown.array().abs() < small.area_mm.array() / 2).all());
        EXPECT_TRUE((shown.array().abs() <= on_small.size_mm.array() / 2 + 1e-9).all());
        EXPECT_LT((twice.tablet_of_plant(node) - (2 * shown + Vec2(5, -3))).norm(), 1e-9);
    }
}

} // namespace
} // namespace tractus::scene
