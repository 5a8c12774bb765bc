#include "engine/variation/stroke_shaper.h"

#include "engine/plant/join_axes.h"
#include "engine/variation/place_nodes.h"
#include "engine/variation/subtree.h"
#include "tests/engine/stroke/strokes.h"
#include "tests/engine/variation/plans.h"
#include "tests/engine/variation/plants.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>

namespace tractus::variation {
namespace {

Stroke hook(double angle)
{
    Quat const turn(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
    std::vector<Vec3> points;
    for (int i = 0; i <= 60; ++i)
        points.push_back(turn * Vec3(40 * (1 - std::cos(0.04 * i)), 0.01 * i * i, 3 * i));
    return stroke_of(points);
}

std::vector<Vec3> shaped_nodes(Plant const& plant, std::vector<Association> const& associations)
{
    auto const rest = find_rest_shape(plant);
    std::vector<Vec3> nodes_mm;
    place_nodes(plant, rest, resolve_associations(plant, rest, associations).value(), nodes_mm);
    return nodes_mm;
}

std::vector<Association> some_associations(Plant const& plant)
{
    auto const path = [&](AxisId id) { return segments_of(plant.axes[id]); };
    return {
        { .path = path(0), .stroke = hook(0), .propagation = Propagation::Both },
        { .path = path(3), .stroke = hook(1), .propagation = Propagation::Selected },
        { .path = path(7), .stroke = hook(2), .propagation = Propagation::Descendants },
        { .path = { path(1)[2], path(1)[3] },
          .stroke = hook(3),
          .propagation = Propagation::Both,
          .fit = StrokeFit::World },
        { .path = path(12), .stroke = hook(4), .fit = StrokeFit::Chord },
        { .path = path(5),
          .stroke = hook(5),
          .propagation = Propagation::Both,
          .laying = StrokeLaying::HeadingAndPitch },
        { .path = { path(5)[1], path(5)[2] },
          .stroke = hook(2),
          .laying = StrokeLaying::HeadingAndPitch },
        { .path = path(2),
          .stroke = hook(1),
          .propagation = Propagation::Descendants,
          .fit = StrokeFit::Chord,
          .laying = StrokeLaying::HeadingAndPitch },
    };
}

bool same_frames(PredefinedShape const& a, PredefinedShape const& b)
{
    for (std::size_t i = 0; i < a.frame.size(); ++i)
        if (a.frame[i].coeffs() != b.frame[i].coeffs())
            return false;
    return a.frame.size() == b.frame.size();
}

TEST(StrokeShaper, ComesAnyWayToTheSameShape)
{
    auto const plant = forking_tree(6, 6);
    auto const rest = find_rest_shape(plant);
    auto const all = some_associations(plant);
    StrokeShaper shaper(plant, rest);
    auto const expect_like_fresh = [&](std::vector<Association> const& now) {
        ASSERT_TRUE(shaper.set(now));
        EXPECT_TRUE(same_frames(shaper.shape(), resolve_associations(plant, rest, now).value()));
    };
    for (std::size_t count = 0; count <= all.size(); ++count)
        expect_like_fresh({ all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count) });
    // Each of the strokes is removed, changed, and restored.
    for (std::size_t gone = 0; gone < all.size(); ++gone) {
        auto fewer = all;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(gone));
        expect_like_fresh(fewer);
        auto changed = all;
        changed[gone].stroke = hook(5);
        expect_like_fresh(changed);
        expect_like_fresh(all);
    }
    expect_like_fresh({});
}

// A stroke whose tips are stored elsewhere. It counts how often they are read.
struct StoredHook : ElementSource<TipSample> {
    Result<std::vector<TipSample>> read() const override
    {
        ++reads;
        return hook(2).tips.vector();
    }
    mutable int reads = 0;
};

TEST(StrokeShaper, ReadsAStrokeAgainOnlyWhereItIsLaidOnAnotherPath)
{
    auto const plant = forking_tree(6, 6);
    auto const rest = find_rest_shape(plant);
    auto const stored = std::make_shared<StoredHook>();
    auto all = some_associations(plant);
    for (std::size_t i = 1; i < 4; ++i)
        all[i].stroke.tips = SharedVector<TipSample>({}, stored).parked();
    StrokeShaper shaper(plant, rest);
    ASSERT_TRUE(shaper.set(all));
    EXPECT_EQ(stored->reads, 3);
    std::rotate(all.begin(), all.begin() + 1, all.end());
    ASSERT_TRUE(shaper.set(all));
    EXPECT_EQ(stored->reads, 3);
    all[0].path = segments_of(plant.axes[5]);
    ASSERT_TRUE(shaper.set(all));
    EXPECT_EQ(stored->reads, 4);
    EXPECT_FALSE(all[0].stroke.tips.is_in_memory());
    EXPECT_TRUE(same_frames(shaper.shape(), resolve_associations(plant, rest, all).value()));
}

TEST(StrokeShaper, TakingAStrokeAwayBringsTheEarlierBack)
{
    auto const plant = forking_tree(5, 6);
    auto all = some_associations(plant);
    std::vector<Association> const first { all[0] };
    auto const before = shaped_nodes(plant, first);
    EXPECT_NE(shaped_nodes(plant, { all[0], all[1] }), before);
    EXPECT_EQ(shaped_nodes(plant, first), before);
}

TEST(StrokeShaper, StaysAsItWasWhenAnAssociationIsRefused)
{
    auto const plant = forking_tree(4, 5);
    auto const rest = find_rest_shape(plant);
    StrokeShaper shaper(plant, rest);
    auto const good = some_associations(plant);
    ASSERT_TRUE(shaper.set(std::span(good).first(1)));
    auto const before = shaper.shape();
    std::vector<Association> const bad { good[0], { .path = { 9999 }, .stroke = hook(0) } };
    EXPECT_FALSE(shaper.set(bad));
    EXPECT_TRUE(same_frames(shaper.shape(), before));
    ASSERT_TRUE(shaper.set(good));
    EXPECT_TRUE(same_frames(shaper.shape(), resolve_associations(plant, rest, good).value()));
}

TEST(StrokeShaper, PassesOverTheOrphaned)
{
    auto const plant = pole(5);
    Association const orphan { .path = {}, .stroke = hook(0), .is_orphaned = true };
    EXPECT_EQ(shaped_nodes(plant, { orphan }), shaped_nodes(plant, {}));
}

TEST(StrokeFit, ChordLeavesTheTipInItsDirection)
{
    auto const plant = hand_made_plant();
    std::vector<Association> const job { { .path = { 4, 5, 6 },
                                           .stroke = hook(1),
                                           .propagation = Propagation::Both,
                                           .fit = StrokeFit::Chord } };
    auto const nodes_mm = shaped_nodes(plant, job);
    auto const& right = plant.axes[1];
    Vec3 const chord = nodes_mm[right.first_node + 3] - nodes_mm[right.first_node];
    // The chords of the segments lie on the stroke. So the tip of the branch is near that of the
    // stroke, but not exactly there, since segments keep their lengths where the stroke bends.
    EXPECT_GT(chord.normalized().x(), 0.999);
    EXPECT_LT(chord.norm(), 150);
    auto const& twig = plant.axes[2];
    Vec3 const twig_chord = nodes_mm[twig.first_node + 2] - nodes_mm[twig.first_node];
    EXPECT_GT(twig_chord.norm(), 50);
    EXPECT_LT(twig_chord.norm(), 60);
}

TEST(StrokeFit, ChordOfALoopIsRefused)
{
    std::vector<Association> const loop { { .path = { 0 },
                                            .stroke
                                            = stroke_of({ { 0, 0, 0 }, { 5, 0, 5 }, { 0, 0, 0 } }),
                                            .fit = StrokeFit::Chord } };
    EXPECT_EQ(shape_of(pole(3), loop).error().message,
              "the stroke ends where it began, so it has no chord to lay along the branch's: fit "
              "it by its start");
}

TEST(StrokeFit, WorldPointsAsWasDrawnWhateverBearsIt)
{
    auto const plant = hand_made_plant();
    // One stroke makes the right branch and its twig hang to -y. Another stroke bends the trunk to
    // +x.
    Stroke const hanging = stroke_of({ { 0, 0, 0 }, { 0, -30, -40 } });
    auto const nodes_mm = shaped_nodes(
        plant,
        { { .path = { 4, 5, 6 },
            .stroke = hanging,
            .propagation = Propagation::Both,
            .fit = StrokeFit::World },
          { .path = { 0, 1, 2, 3 }, .stroke = hook(0), .propagation = Propagation::Selected } });
    for (AxisId const id : { 1u, 2u }) {
        auto const& axis = plant.axes[id];
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            Vec3 const step = nodes_mm[axis.first_node + i + 1] - nodes_mm[axis.first_node + i];
            EXPECT_LT((step.normalized() - Vec3(0, -0.6, -0.8)).norm(), 1e-12);
        }
    }
    // The left branch must move with the bent trunk.
    Vec3 const left = nodes_mm[plant.axes[3].first_node + 2] - nodes_mm[plant.axes[3].first_node];
    EXPECT_GT(left.normalized().z(), 0.1);
}

TEST(PlaceNodes, GivesTheBasePlantWithoutStrokes)
{
    auto const plant = forking_tree(7, 4);
    auto const nodes_mm = shaped_nodes(plant, {});
    for (std::size_t i = 0; i < nodes_mm.size(); ++i)
        EXPECT_LT((nodes_mm[i] - plant.node_position_mm[i]).norm(), 1e-9);
}

TEST(PlaceNodes, KeepsGapsInTheParentsFrame)
{
    auto plant = pole(4, 400);
    // The new branch begins 20 mm beside the tip of its parent.
    add_axis(plant, straight({ 20, 0, 400 }, { 80, 0, 400 }, 2), 0, 3);
    auto const nodes_mm = shaped_nodes(
        plant,
        { { .path = { 0, 1, 2, 3 }, .stroke = hook(0), .propagation = Propagation::Selected } });
    EXPECT_NEAR((nodes_mm[5] - nodes_mm[4]).norm(), 20, 1e-9);
    Vec3 const last = (nodes_mm[4] - nodes_mm[3]).normalized();
    EXPECT_NEAR((nodes_mm[5] - nodes_mm[4]).dot(last), 0, 1e-9);
}

TEST(SubtreeOf, IsTheRestOfTheAxisAndAllThatStandsOnIt)
{
    auto const plant = hand_made_plant();
    auto const subtree = subtree_of(plant, 2);
    ASSERT_EQ(subtree.size(), 2u);
    EXPECT_EQ(subtree[0].axis, 0u);
    EXPECT_EQ(subtree[0].first, 2u);
    EXPECT_EQ(subtree[1].axis, 3u);
    EXPECT_EQ(subtree_of(plant, 1).size(), 4u);
    EXPECT_EQ(subtree_of(plant, 5).size(), 1u);
}

} // namespace
} // namespace tractus::variation
