#include "engine/variation/association.h"

#include "engine/stroke/resample.h"
#include "engine/variation/growth.h"
#include "tests/engine/stroke/strokes.h"
#include "tests/engine/variation/plans.h"
#include "tests/engine/variation/plants.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

namespace tractus::variation {
namespace {

// Returns a stroke along a quarter circle that starts upwards and ends to the right.
Stroke quarter_circle()
{
    std::vector<Vec3> points;
    for (int i = 0; i <= 90; ++i)
        points.push_back({ 100 * (1 - std::cos(radians(i))), 0, 100 * std::sin(radians(i)) });
    return stroke_of(points);
}

Plant shaped(Plant const& plant, std::vector<Association> const& associations)
{
    return grow({ .plant = plant, .associations = associations, .parameters = { .strength = 0 } })
        .value();
}

// Returns how much the angle between a segment and the segment below it differs from that in the
// base plant.
double bend_deg(Plant const& base, Plant const& bent, SegmentId segment)
{
    auto const angle = [&](Plant const& plant) {
        double const cosine
            = direction_of(plant, segment).dot(direction_of(plant, parent_segment(plant, segment)));
        return degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
    };
    return angle(bent) - angle(base);
}

TEST(Association, BendsThePathAsDrawn)
{
    auto const plant = pole(30);
    std::vector<SegmentId> path(30);
    for (SegmentId segment = 0; segment < 30; ++segment)
        path[segment] = segment;
    auto const bent = shaped(plant, { { .path = path, .stroke = quarter_circle() } });
    // Radius of a quarter circle whose length is the pole's, 1000 mm.
    double const radius_mm = 1000 / (kPi / 2);
    Vec3 const tip = bent.node_position_mm.back();
    // The start tangent of the stroke is measured over its first twentieth, which makes an error of
    // 2.25 degrees.
    Quat const turn(Eigen::AngleAxisd(-radians(2.25), Vec3::UnitY()));
    EXPECT_LT((tip - turn * Vec3(radius_mm, 0, radius_mm)).norm(), 2);
}

TEST(Association, ScaleOfTheStrokeDoesNotMatter)
{
    auto const plant = hand_made_plant();
    auto small = quarter_circle();
    for (auto& tip : small.tips.own())
        tip.position_mm = 0.01 * tip.position_mm + Vec3(7, 8, 9);
    auto const a = shaped(plant, { { .path = { 0, 1, 2, 3 }, .stroke = quarter_circle() } });
    auto const b = shaped(plant, { { .path = { 0, 1, 2, 3 }, .stroke = small } });
    for (std::size_t i = 0; i < a.node_position_mm.size(); ++i)
        EXPECT_LT((a.node_position_mm[i] - b.node_position_mm[i]).norm(), 1e-9);
}

TEST(Association, SelectedBendsThePathAndCarriesTheRest)
{
    auto const plant = hand_made_plant();
    auto const bent = shaped(plant,
                             { { .path = { 0, 1, 2, 3 },
                                 .stroke = quarter_circle(),
                                 .propagation = Propagation::Selected } });
    check_plant(bent);
    EXPECT_NEAR(bend_deg(plant, bent, 1), 22.5, 0.1);
    EXPECT_NEAR(bend_deg(plant, bent, 3), 22.5, 0.1);
    for (SegmentId const carried : { 4u, 5u, 6u, 7u, 8u, 9u, 10u })
        EXPECT_NEAR(bend_deg(plant, bent, carried), 0, 1e-5) << carried;
    // The branch on the right moves with the second segment of the trunk, which leans to the right
    // by about 32 degrees.
    EXPECT_NEAR(degrees(std::asin(-direction_of(bent, 4).z())), 33.75 - 2.25, 0.1);
}

TEST(Association, DescendantsBendsWhatThePathBearsOnly)
{
    auto const plant = hand_made_plant();
    auto const bent = shaped(plant,
                             { { .path = { 0, 1, 2, 3 },
                                 .stroke = quarter_circle(),
                                 .propagation = Propagation::Descendants } });
    for (NodeId node = 0; node <= 4; ++node)
        EXPECT_LT((bent.node_position_mm[node] - plant.node_position_mm[node]).norm(), 1e-9);
    // The quarter circle is divided over three segments, of which two bend.
    EXPECT_NEAR(bend_deg(plant, bent, 5), 30, 0.1);
    EXPECT_NEAR(bend_deg(plant, bent, 8), 45, 0.1);
    EXPECT_NEAR(bend_deg(plant, bent, 10), 45, 0.1);
}

TEST(Association, DescendantsTakeTheStrokeInTheirOwnFrames)
{
    auto const plant = hand_made_plant();
    auto const bent = shaped(plant,
                             { { .path = { 0, 1, 2, 3 },
                                 .stroke = quarter_circle(),
                                 .propagation = Propagation::Descendants } });
    // The stroke bends the trunk to +x, the direction of the trunk's normal. The normal of a branch
    // is the direction of its parent, so both branches bend upwards.
    EXPECT_GT(direction_of(bent, 6).z(), 0.9);
    EXPECT_GT(direction_of(bent, 10).z(), 0.8);
    // The twig on the right branch bends towards the direction of this branch at the twig's base.
    EXPECT_GT(direction_of(bent, 8).dot(direction_of(bent, 4)), 0.8);
}

TEST(Association, BothBendsThePathAndWhatItBears)
{
    auto const plant = hand_made_plant();
    auto const bent = shaped(plant,
                             { { .path = { 0, 1, 2, 3 },
                                 .stroke = quarter_circle(),
                                 .propagation = Propagation::Both } });
    EXPECT_NEAR(bend_deg(plant, bent, 3), 22.5, 0.1);
    EXPECT_NEAR(bend_deg(plant, bent, 5), 30, 0.1);
    EXPECT_NEAR(bend_deg(plant, bent, 8), 45, 0.1);
}

TEST(Association, WhatIsNotBelowThePathStaysAsItWas)
{
    auto const plant = hand_made_plant();
    auto const bent = shaped(
        plant,
        { { .path = { 4, 5, 6 }, .stroke = quarter_circle(), .propagation = Propagation::Both } });
    for (NodeId const node : { 0u, 1u, 2u, 3u, 4u, 12u, 13u, 14u })
        EXPECT_LT((bent.node_position_mm[node] - plant.node_position_mm[node]).norm(), 1e-9)
            << node;
    EXPECT_NEAR(bend_deg(plant, bent, 6), 30, 0.1);
    EXPECT_NEAR(bend_deg(plant, bent, 8), 45, 0.1);
}

TEST(Association, APathMayGoOnIntoALateralAxis)
{
    auto const plant = hand_made_plant();
    std::vector<SegmentId> const path { 0, 1, 4, 7, 8 };
    auto const straightened
        = shaped(plant, { { .path = path, .stroke = stroke_of({ { 0, 0, 0 }, { 0, 0, 50 } }) } });
    for (auto const segment : path)
        EXPECT_LT((direction_of(straightened, segment) - Vec3::UnitZ()).norm(), 1e-12) << segment;
    // The path leaves the axis before its end. The rest of the axis must keep its own shape.
    EXPECT_NEAR(bend_deg(plant, straightened, 2), 0, 1e-5);
    EXPECT_NEAR(bend_deg(plant, straightened, 6), 0, 1e-5);
}

TEST(Association, TheRestOfAnAxisGoesStraightOnFromThePathsEnd)
{
    auto const plant = pole(10);
    auto const bent = shaped(plant, { { .path = { 0, 1, 2, 3 }, .stroke = quarter_circle() } });
    for (SegmentId segment = 4; segment < 10; ++segment)
        EXPECT_LT((direction_of(bent, segment) - direction_of(bent, 3)).norm(), 1e-12);
}

TEST(Association, TheLaterOneWinsWhereTheyMeet)
{
    auto const plant = pole(12);
    Association const all { .path = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 },
                            .stroke = quarter_circle() };
    Association const middle { .path = { 4, 5, 6 },
                               .stroke = stroke_of({ { 0, 0, 0 }, { 0, 0, 9 } }) };
    auto const bent = shaped(plant, { all, middle });
    EXPECT_NEAR(bend_deg(plant, bent, 3), 7.5, 0.1);
    for (SegmentId const straight : { 4u, 5u, 6u })
        EXPECT_NEAR(bend_deg(plant, bent, straight), 0, 1e-5);
    // Behind the straight middle, the rest of the path must keep the shape of the first stroke.
    EXPECT_NEAR(bend_deg(plant, bent, 8), 7.5, 0.1);
    auto const other_way = shaped(plant, { middle, all });
    EXPECT_NEAR(bend_deg(plant, other_way, 5), 7.5, 0.1);
}

TEST(Association, OnesOwnStrokeOverridesWhatWasPropagated)
{
    auto const plant = hand_made_plant();
    auto const bent = shaped(
        plant,
        { { .path = { 0, 1, 2, 3 }, .stroke = quarter_circle(), .propagation = Propagation::Both },
          { .path = { 4, 5, 6 }, .stroke = stroke_of({ { 0, 0, 0 }, { 10, 0, 0 } }) } });
    EXPECT_NEAR(bend_deg(plant, bent, 5), 0, 1e-5);
    EXPECT_NEAR(bend_deg(plant, bent, 6), 0, 1e-5);
    EXPECT_NEAR(bend_deg(plant, bent, 8), 45, 0.1);
    EXPECT_NEAR(bend_deg(plant, bent, 10), 45, 0.1);
}

TEST(Association, EditingTheTrunkCarriesABranchThatHasItsOwnStroke)
{
    auto const plant = hand_made_plant();
    Association const branch { .path = { 4, 5, 6 }, .stroke = quarter_circle() };
    Association const trunk { .path = { 0, 1, 2, 3 }, .stroke = quarter_circle() };
    auto const before = shaped(plant, { branch });
    auto const after = shaped(plant, { branch, trunk });
    for (SegmentId const segment : { 5u, 6u, 7u, 8u })
        EXPECT_NEAR(bend_deg(plant, after, segment), bend_deg(plant, before, segment), 1e-5);
}

TEST(Association, EachBranchStartsAsInTheBasePlant)
{
    auto const plant = pole(40);
    std::vector<SegmentId> path(40);
    for (SegmentId segment = 0; segment < 40; ++segment)
        path[segment] = segment;
    // The stroke is drawn downwards with tremor.
    auto drawn = trembling(s_curve(300), 0.3);
    for (auto& point : drawn)
        point.z() = -point.z();
    auto const bent = shaped(plant, { { .path = path, .stroke = stroke_of(drawn) } });
    EXPECT_EQ(bent.node_position_mm[0], Vec3(0, 0, 0));
    EXPECT_GT(bent.node_position_mm[2].normalized().z(), 0.99);
}

TEST(Association, LessOfTheHandIsSmoother)
{
    auto const plant = pole(60);
    Association association { .path = {}, .stroke = stroke_of(trembling(s_curve(200), 1)) };
    for (SegmentId segment = 0; segment < 60; ++segment)
        association.path.push_back(segment);
    auto const roughness = [&](double detail_weight) {
        association.detail_weight = detail_weight;
        auto const bent = shaped(plant, { association });
        double sum = 0;
        for (SegmentId segment = 1; segment < 60; ++segment)
            sum += std::abs(bend_deg(plant, bent, segment));
        return sum;
    };
    EXPECT_LT(roughness(0), 0.6 * roughness(1));
    EXPECT_LT(roughness(0.5), roughness(1));
}

TEST(Association, AClosedLoopIsAShapeLikeAnother)
{
    std::vector<Vec3> loop;
    for (int i = 0; i <= 72; ++i)
        loop.push_back({ 50 * (1 - std::cos(radians(5 * i))), 0, 50 * std::sin(radians(5 * i)) });
    auto const plant = pole(36);
    Association association { .path = {}, .stroke = stroke_of(loop) };
    for (SegmentId segment = 0; segment < 36; ++segment)
        association.path.push_back(segment);
    auto const bent = shaped(plant, { association });
    EXPECT_LT(bent.node_position_mm.back().norm(), 1);
}

TEST(Association, RefusesBadStrokes)
{
    double const nan = std::numeric_limits<double>::quiet_NaN();
    for (auto const& stroke :
         { Stroke {}, stroke_of({ { 1, 1, 1 } }), stroke_of({ { 1, 1, 1 }, { 1, 1, 1 } }),
           stroke_of({ { 1, 1, 1 }, { 1, nan, 1 }, { 2, 2, 2 } }) }) {
        std::vector<Association> const bad { { .path = { 0 }, .stroke = stroke } };
        auto const shape = shape_of(hand_made_plant(), bad);
        ASSERT_FALSE(shape);
        EXPECT_EQ(shape.error().fault, Fault::User);
    }
}

TEST(Association, RefusesBadPaths)
{
    auto const error = [](std::vector<SegmentId> const& path) {
        std::vector<Association> const bad { { .path = path, .stroke = quarter_circle() } };
        return shape_of(hand_made_plant(), bad).error().message;
    };
    EXPECT_EQ(error({}), "no branch is selected for the stroke: select one first");
    EXPECT_EQ(error({ 99 }),
              "segment 99 is not in the plant, which has 11: select the branch again");
    EXPECT_EQ(error({ 0, 2 }),
              "segment 2 does not stand on segment 0, so the selected path is broken: "
              "select it again");
}

TEST(Association, RefusesToKeepMoreThanTheHand)
{
    std::vector<Association> const bad {
        { .path = { 0 }, .stroke = quarter_circle(), .detail_weight = 1.5 }
    };
    EXPECT_EQ(shape_of(hand_made_plant(), bad).error().message,
              "1.5 of the hand cannot be kept: give a share from 0 to 1");
}

TEST(Association, APlantWithSegmentsWithoutLengthSurvives)
{
    auto plant = pole(4);
    plant.node_position_mm[1] = plant.node_position_mm[0];
    plant.node_position_mm[3] = plant.node_position_mm[2];
    auto const bent = shaped(plant, { { .path = { 0, 1, 2, 3 }, .stroke = quarter_circle() } });
    check_plant(bent);
    auto const point = pole(3, 0);
    check_plant(shaped(point, { { .path = { 0, 1, 2 }, .stroke = quarter_circle() } }));
}

} // namespace
} // namespace tractus::variation
