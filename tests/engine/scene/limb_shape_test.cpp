#include "tests/engine/scene/limbs.h"

#include <rapidcheck/gtest.h>

namespace tractus::scene {
namespace {

TEST(LimbShape, FollowTheStrokeFromWhereItBegins)
{
    auto const before = tree_scene();
    auto const places_mm = winding({ 40, 10, 330 }, 400);
    auto const scene = after({ on_segment(before, 2, places_mm) }, before);
    check_plant(*scene.base);
    auto const& limb = limb_axis(scene);
    EXPECT_EQ(limb.parent_segment, 2u);
    EXPECT_EQ(limb.order, 1u);
    auto const nodes_mm = scene.base->positions(limb);
    EXPECT_EQ(nodes_mm.front(), Vec3(0, 0, 300)) << "on the trunk";
    EXPECT_TRUE(nodes_mm.back().isApprox(places_mm.back(), 1e-12));
    auto const begin = std::find_if(nodes_mm.begin(), nodes_mm.end(), [&](Vec3 const& node) {
        return (node - places_mm.front()).norm() < 1e-6;
    });
    ASSERT_NE(begin, nodes_mm.end()) << "the stroke's beginning is a node";
    for (auto node = begin; node != nodes_mm.end(); ++node)
        EXPECT_LT(distance_to(places_mm, *node), 1e-6);
    for (auto node = nodes_mm.begin(); node != begin; ++node)
        EXPECT_LT((*node - Vec3(20, 5, 315)).norm(), 40) << "the curve that joins it is short";
}

TEST(LimbShape, BearTheTwigsOfTheNearestBranchByLength)
{
    auto const before = tree_scene();
    double const branch_mm = before.rest->axis_length_mm[1];
    for (double const ratio : { 0.5, 0.8, 1.0, 1.25, 2.0 }) {
        std::vector<Vec3> const line_mm { { 0, 0, 300 }, { ratio * branch_mm, 0, 300 } };
        auto const scene = after({ on_segment(before, 2, line_mm) }, before);
        auto const& limb = limb_axis(scene);
        EXPECT_NEAR(static_cast<double>(laterals_on(*scene.base, limb)), 6 * ratio, 1) << ratio;
    }
}

TEST(LimbShape, AreAsThickAsThePenIsPressed)
{
    auto const before = tree_scene();
    std::vector<Vec3> const line_mm { { 0, 0, 300 }, { 100, 0, 320 }, { 250, 0, 330 } };
    auto edit = on_segment(before, 2, line_mm);
    edit.width_mm = 10;
    auto const base_mm = [&](double pressure) {
        edit.stroke = stroke_of(line_mm, pressure);
        auto const scene = after({ edit }, before);
        auto const& limb = limb_axis(scene);
        auto const* const radius = &scene.base->node_radius_mm[limb.first_node];
        EXPECT_GT(radius[0], 1.5f * radius[limb.segment_count]) << "it tapers as branches do";
        return 2 * static_cast<double>(radius[0]);
    };
    EXPECT_NEAR(base_mm(0.5), 10 * ink_width_share(0.5), 1e-5);
    EXPECT_NEAR(base_mm(1), 10, 1e-5);
    edit.width_mm = 1000;
    EXPECT_LT(base_mm(1) / 2, static_cast<double>(before.base->node_radius_mm[3]))
        << "thinner than the trunk";
}

TEST(LimbShape, ThickenWhereThePenIsPressedHarder)
{
    auto const before = tree_scene();
    auto const places_mm = winding({ 0, 0, 300 }, 300);
    auto even = on_segment(before, 2, places_mm);
    auto swelling = even;
    for (std::size_t i = 0; i < places_mm.size(); ++i)
        swelling.stroke.tips.own()[i].pressure
            = 0.5 + 0.3 * std::sin(kPi * static_cast<double>(i) / 30);
    auto const one = after({ even }, before);
    auto const other = after({ swelling }, before);
    auto const& axis = limb_axis(one);
    auto const ratio = [&](std::uint32_t node) {
        return other.base->node_radius_mm[axis.first_node + node]
            / one.base->node_radius_mm[axis.first_node + node];
    };
    EXPECT_GT(ratio(axis.segment_count / 4), 1.1f);
    EXPECT_LT(ratio(3 * axis.segment_count / 4), 0.9f);
}

// If the whole drawing is rotated about the vertical axis, the limb must be rotated with it.
RC_GTEST_PROP(LimbShape, TurnWithTheDrawing, ())
{
    double const turned_deg = *rc::gen::inRange(-180, 180);
    auto const segment = *rc::gen::inRange<SegmentId>(0, 40);
    // A positive "/" makes the turtle turn to the right, which is a left-handed rotation about the
    // upward direction.
    auto const one = tree_scene();
    auto const other = tree_scene(turned_deg);
    Vec3 const tip_mm = one.base->positions(one.base->axes[1]).back();
    Vec3 const turned_mm = other.base->positions(other.base->axes[1]).back();
    double const angle
        = std::atan2(turned_mm.y(), turned_mm.x()) - std::atan2(tip_mm.y(), tip_mm.x());
    Quat const turn(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
    auto const place = [&](Scene const& scene) {
        return scene.base->node_position_mm[nodes_of(*scene.base, segment).tip];
    };
    RC_ASSERT((turn * place(one) - place(other)).norm() < 1e-6);
    auto places_mm = winding(place(one) + Vec3(3, 20, 10), 350);
    auto const drawn = after({ on_segment(one, segment, places_mm) }, one);
    for (auto& point : places_mm)
        point = turn * point;
    auto const drawn_turned = after({ on_segment(other, segment, places_mm) }, other);
    RC_ASSERT(drawn.base->axes.size() == drawn_turned.base->axes.size());
    for (std::size_t i = 0; i < drawn.base->node_position_mm.size(); ++i)
        RC_ASSERT(
            (turn * drawn.base->node_position_mm[i] - drawn_turned.base->node_position_mm[i]).norm()
            < 1e-6);
}

} // namespace
} // namespace tractus::scene
