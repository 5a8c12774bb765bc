#include "engine/base/random.h"
#include "engine/plant/join_axes.h"
#include "engine/variation/place_nodes.h"
#include "engine/variation/stroke_laying.h"
#include "tests/app/our_plant.h"
#include "tests/engine/stroke/strokes.h"

#include <gtest/gtest.h>

// Properties of the fit of strokes by heading and pitch, tested with random strokes on the models
// that come with the program.

namespace tractus::variation {
namespace {

constexpr int kStrokes = 20; // Number of random strokes for each of the five models.

class LaidStrokes : public ::testing::TestWithParam<char const*> {
protected:
    LaidStrokes()
        : scene_(our_plant(GetParam()))
        , rest_(find_rest_shape(*scene_.base))
    {
    }

    Plant const& plant() const { return *scene_.base; }
    RestShape const& rest() const { return rest_; }

    std::vector<Vec3> nodes(Association association) const
    {
        association.laying = StrokeLaying::HeadingAndPitch;
        std::vector<Vec3> nodes_mm;
        place_nodes(plant(), rest_,
                    resolve_associations(plant(), rest_, { &association, 1 }).value(), nodes_mm);
        return nodes_mm;
    }

    std::vector<Vec3> propagated(std::vector<Vec3> const& points, StrokeFit fit) const
    {
        return nodes({ .path = segments_of(plant().axes[0]),
                       .stroke = stroke_of(points),
                       .propagation = Propagation::Descendants,
                       .fit = fit });
    }

    // Returns the trunk's laterals that are not upright, so that their heading counts.
    std::vector<AxisId> branches(StrokeFit fit) const
    {
        std::vector<AxisId> found;
        for (AxisId id = 0; id < plant().axes.size(); ++id)
            if (plant().axes[id].parent_axis == 0 && rest_.axis_length_mm[id] > 0
                && !is_upright(direction(id, fit)))
                found.push_back(id);
        return found;
    }

    std::span<double const> lengths(AxisId id) const
    {
        auto const& axis = plant().axes[id];
        return std::span(rest_.length_mm).subspan(axis.first_segment, axis.segment_count);
    }

    Vec3 direction(AxisId id, StrokeFit fit) const
    {
        auto const& axis = plant().axes[id];
        auto const frames = std::span(rest_.frame).subspan(axis.first_segment, axis.segment_count);
        return branch_direction(frames, lengths(id), fit, start_share(lengths(id), {}));
    }

    // Returns the vector from the base of an axis to its tip.
    Vec3 chord(std::vector<Vec3> const& nodes, AxisId id) const
    {
        auto const& axis = plant().axes[id];
        return nodes[axis.first_node + axis.segment_count] - nodes[axis.first_node];
    }

private:
    scene::Scene scene_;
    RestShape rest_;
};

// Returns a smooth random path of 40 steps that may bend in any direction.
std::vector<Vec3> random_stroke(Random& random)
{
    auto const number = [&] { return 2 * random.uniform() - 1; };
    Vec3 direction(number(), number(), number());
    Vec3 turn = 0.2 * Vec3(number(), number(), number());
    std::vector<Vec3> points { 100 * Vec3(number(), number(), number()) };
    for (int i = 0; i < 40; ++i) {
        turn = 0.85 * turn + 0.06 * Vec3(number(), number(), number());
        direction = (direction.normalized() + turn).normalized();
        points.push_back(points.back() + 5 * direction);
    }
    return points;
}

double farthest(std::vector<Vec3> const& one, std::vector<Vec3> const& other)
{
    double greatest = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        greatest = std::max(greatest, (one[i] - other[i]).norm());
    return greatest;
}

TEST_P(LaidStrokes, TurningTheDrawingChangesNothing)
{
    Random random({ .seed = 1 });
    for (int i = 0; i < kStrokes; ++i) {
        auto const drawn = random_stroke(random);
        Quat const turn(Eigen::AngleAxisd(6.3 * random.uniform(), Vec3::UnitZ()));
        auto turned = drawn;
        for (auto& point : turned)
            point = turn * point;
        for (auto const fit : { StrokeFit::Start, StrokeFit::Chord })
            EXPECT_LT(farthest(propagated(drawn, fit), propagated(turned, fit)), 1e-6) << i;
        // With StrokeFit::World, each branch turns with the stroke.
        auto const world = propagated(drawn, StrokeFit::World);
        auto const turned_world = propagated(turned, StrokeFit::World);
        for (AxisId const id : branches(StrokeFit::Start))
            EXPECT_LT((turn * chord(world, id) - chord(turned_world, id)).norm(), 1e-6) << i;
    }
}

TEST_P(LaidStrokes, AMirroredDrawingMirrorsEachBranch)
{
    Random random({ .seed = 2 });
    for (int i = 0; i < kStrokes; ++i) {
        auto const drawn = random_stroke(random);
        auto mirrored = drawn;
        for (auto& point : mirrored)
            point.y() = -point.y();
        for (auto const fit : { StrokeFit::Start, StrokeFit::Chord }) {
            auto const one = propagated(drawn, fit);
            auto const other = propagated(mirrored, fit);
            for (AxisId const id : branches(fit)) {
                auto const& axis = plant().axes[id];
                // Normal of the vertical plane through the branch.
                Vec3 const side = Vec3::UnitZ().cross(direction(id, fit)).normalized();
                for (auto n = axis.first_node; n <= axis.first_node + axis.segment_count; ++n) {
                    Vec3 const way = one[n] - one[axis.first_node];
                    Vec3 const reflected = way - 2 * way.dot(side) * side;
                    EXPECT_LT((other[n] - other[axis.first_node] - reflected).norm(), 1e-6);
                }
            }
        }
    }
}

TEST_P(LaidStrokes, StartsAndChordsAreThoseOfTheBranches)
{
    Random random({ .seed = 3 });
    for (int i = 0; i < kStrokes; ++i) {
        auto const drawn = random_stroke(random);
        auto const by_start = propagated(drawn, StrokeFit::Start);
        auto const by_chord = propagated(drawn, StrokeFit::Chord);
        for (AxisId const id : branches(StrokeFit::Start)) {
            auto const& axis = plant().axes[id];
            // The first segment has the direction of the stroke's start if it is not a small part
            // of the branch.
            double const shown = rest().length_mm[axis.first_segment] / rest().axis_length_mm[id];
            Vec3 const first = by_start[axis.first_node + 1] - by_start[axis.first_node];
            if (shown >= 0.05 && shown <= 1.0 / 3)
                EXPECT_LT((first.normalized() - direction(id, StrokeFit::Start)).norm(), 1e-9);
            EXPECT_LT((chord(by_chord, id).normalized() - direction(id, StrokeFit::Chord)).norm(),
                      1e-9);
        }
    }
}

TEST_P(LaidStrokes, ABranchsOwnCurveGivesItBack)
{
    auto const undrawn = plant().node_position_mm;
    for (auto const fit : { StrokeFit::Start, StrokeFit::Chord }) {
        int count = 0;
        for (AxisId id = 0; id < plant().axes.size() && count < 20; ++id) {
            auto const& axis = plant().axes[id];
            if (axis.segment_count < 3 || (axis.order > 0 && is_upright(direction(id, fit))))
                continue;
            ++count;
            auto const own = plant().positions(axis);
            auto const drawn = nodes({ .path = segments_of(axis),
                                       .stroke = stroke_of({ own.begin(), own.end() }),
                                       .fit = fit });
            EXPECT_LT(farthest(drawn, undrawn), 1e-6) << id;
        }
        EXPECT_GT(count, 0);
    }
}

// A hanging stroke is everywhere below the line of its start. Branches with a curve of their own
// are compared with their straight continuation, since the law does not include that curve.
TEST_P(LaidStrokes, WhatHangsRaisesNoTipAndWhatRisesLowersNone)
{
    Random random({ .seed = 4 });
    for (int i = 0; i < kStrokes; ++i) {
        double const heading = 6.3 * random.uniform();
        double const fall = 0.3 + random.uniform();
        for (double const sign : { -1.0, 1.0 }) {
            std::vector<Vec3> points;
            for (int k = 0; k <= 40; ++k) {
                double const t = k / 40.0;
                Vec2 const out = 120 * t * Vec2(std::cos(heading), std::sin(heading));
                points.push_back({ out.x(), out.y(), sign * 60 * fall * t * t });
            }
            auto const drawn = propagated(points, StrokeFit::Start);
            for (AxisId const id : branches(StrokeFit::Start)) {
                Vec3 const start = direction(id, StrokeFit::Start);
                // If a steep branch bends beyond the vertical, its tip rises again on the other
                // side.
                if (std::abs(start.z()) > 0.6)
                    continue;
                double const straight = rest().axis_length_mm[id] * start.z();
                EXPECT_GE(sign * (chord(drawn, id).z() - straight), -1e-9) << i << " " << id;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Models, LaidStrokes,
                         ::testing::Values("broadleaf", "conifer", "birch", "poplar", "shrub"),
                         [](auto const& model) { return std::string(model.param); });

} // namespace
} // namespace tractus::variation
