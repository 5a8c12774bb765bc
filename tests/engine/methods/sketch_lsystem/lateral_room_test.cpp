#include "engine/methods/sketch_lsystem/lateral_room.h"

#include "engine/methods/sketch_lsystem/grow_edit.h"
#include "engine/methods/sketch_lsystem/stroke_resampler.h"
#include "tests/engine/methods/sketch_lsystem/strokes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

namespace tractus::sketch {
namespace {

constexpr double kLegs_mm = 44; // Distance between the two legs of the U.

// Returns a stroke that leads up, bends over, and leads down again beside itself.
std::vector<Vec3> u_turn()
{
    std::vector<Vec3> tips;
    for (int i = 0; i <= 200; ++i)
        tips.emplace_back(0, 0, i);
    for (int i = 1; i < 100; ++i)
        tips.emplace_back(kLegs_mm / 2 * (1 - std::cos(kPi * i / 100)), 0,
                          200 + kLegs_mm / 2 * std::sin(kPi * i / 100));
    for (int i = 200; i >= 0; --i)
        tips.emplace_back(kLegs_mm, 0, i);
    return tips;
}

Rule wide_rule(double occupancy_radius_mm)
{
    Rule rule { .first_length_mm = 20, .length_ratio = 1, .first_width_mm = 2, .laterals = 3 };
    rule.angle_deg = 60;
    rule.lateral_length = 0.75;
    rule.shortest_mm = 3;
    rule.occupancy_radius_mm = occupancy_radius_mm;
    return rule;
}

GrowAlongStroke along(std::vector<Vec3> const& tips_mm, Rule const& rule)
{
    GrowAlongStroke edit { .rule = rule, .leaves = Leaves::Bare };
    for (auto const& tip_mm : tips_mm)
        edit.stroke.tips.push_back({ .position_mm = tip_mm, .touching = true });
    return edit;
}

// Returns how far laterals on the legs reach beyond the middle between the legs, in mm on the desk.
double overlap_mm(GrowAlongStroke const& edit)
{
    auto const plant = build_sketch(edit, {}).value().plant;
    std::vector<double> root_x(plant.axes.size(), 0);
    double most_mm = 0;
    for (std::size_t a = 1; a < plant.axes.size(); ++a) {
        auto const& axis = plant.axes[a];
        auto const nodes = plant.positions(axis);
        Vec3 const base_mm = edit.scale * nodes.front();
        bool const is_first = axis.parent_axis == 0;
        root_x[a] = is_first ? base_mm.x() : root_x[axis.parent_axis];
        for (auto const& node : nodes) {
            Vec3 const node_mm = edit.scale * node;
            if (node_mm.z() > 170)
                continue;
            double const beyond_mm = root_x[a] < kLegs_mm / 2 ? node_mm.x() - kLegs_mm / 2
                                                              : kLegs_mm / 2 - node_mm.x();
            most_mm = std::max(most_mm, beyond_mm);
        }
    }
    return most_mm;
}

std::vector<double> room_along(std::vector<Vec3> const& tips_mm, Rule const& rule)
{
    auto const nodes_mm = resample_stroke(rule, tips_mm);
    return draw_axis(rule, nodes_mm).room;
}

TEST(LateralRoom, AUTurnDoesNotOverlapItself)
{
    EXPECT_GT(overlap_mm(along(u_turn(), wide_rule(0))), 5);
    EXPECT_LE(overlap_mm(along(u_turn(), wide_rule(0.1))), 0.01);
    EXPECT_LE(overlap_mm(along(u_turn(), wide_rule(6))), 0.01);
}

TEST(LateralRoom, ShrinksWithTheRadius)
{
    double before = 1e9;
    for (double const radius_mm : { 0.1, 4.0, 12.0, 30.0, 60.0 }) {
        auto const room = room_along(u_turn(), wide_rule(radius_mm));
        EXPECT_EQ(room.size() % 3, 0U);
        for (double const share : room) {
            EXPECT_GE(share, 0);
            EXPECT_LE(share, 1);
            EXPECT_FALSE(share > 0 && share < 0.25) << "too short to grow";
        }
        double const sum = std::accumulate(room.begin(), room.end(), 0.0);
        EXPECT_LE(sum, before);
        before = sum;
    }
}

TEST(LateralRoom, IsAllAlongAStrokeThatDoesNotTurnBack)
{
    for (auto const& tips_mm : { straight_stroke(300), bow() })
        for (double const share : room_along(tips_mm, wide_rule(8)))
            EXPECT_EQ(share, 1);
}

// Moving the stroke, or rotating it about the vertical axis, must only change which lateral is
// which.
TEST(LateralRoom, MovesWithTheStroke)
{
    auto const room = room_along(u_turn(), wide_rule(4));
    auto tips_mm = u_turn();
    for (auto& tip_mm : tips_mm)
        tip_mm += Vec3(-30, 12, 7);
    auto const moved = room_along(tips_mm, wide_rule(4));
    ASSERT_EQ(moved.size(), room.size());
    for (std::size_t i = 0; i < room.size(); ++i)
        EXPECT_NEAR(moved[i], room[i], 0.0011);
}

TEST(LateralRoom, OfLateralsThatGoOnByRulesOfTheirOwn)
{
    auto rule = wide_rule(2);
    rule.lateral_rules = { { .laterals = 2, .lateral_length = 0.5 } };
    EXPECT_LE(overlap_mm(along(u_turn(), rule)), 0.01);
    rule.occupancy_radius_mm = 0;
    EXPECT_GT(overlap_mm(along(u_turn(), rule)), 5);
}

TEST(LateralRoom, IsOffInOldDrawings)
{
    EXPECT_EQ(Rule().occupancy_radius_mm, 0);
    auto const model = model_of(along(u_turn(), wide_rule(0))).value();
    EXPECT_EQ(model.text.find("room"), std::string::npos);
    auto const tidy = model_of(along(u_turn(), wide_rule(3))).value();
    EXPECT_NE(tidy.text.find("array room["), std::string::npos);
    EXPECT_FALSE(check_rule(wide_rule(101)));
    EXPECT_FALSE(check_rule(wide_rule(-1)));
}

} // namespace
} // namespace tractus::sketch
