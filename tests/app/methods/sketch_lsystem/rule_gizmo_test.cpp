#include "app/methods/all_methods.h"
#include "app/methods/sketch_lsystem/sketch_options.h"
#include "app/methods/sketch_lsystem/sketch_tool.h"
#include "engine/methods/sketch_lsystem/change_edits.h"
#include "engine/scene/scene.h"
#include "tests/app/small_model.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace tractus::sketch {
namespace {

tools::Gizmo::Handle const& handle_of(tools::Gizmo const& gizmo, std::string_view sign)
{
    return *std::find_if(gizmo.handles.begin(), gizmo.handles.end(),
                         [&](tools::Gizmo::Handle const& handle) { return handle.sign == sign; });
}

SketchTool dragged(SketchTool const& tool, std::string_view sign, Vec2 const& to)
{
    auto const& hand = tools::Tool(tool);
    auto const gizmo = hand.gizmo();
    return *hand.dragged(handle_of(gizmo, sign).id, to).get<SketchTool>();
}

Vec2 place_of_handle(SketchTool const& tool, std::string_view sign)
{
    auto const gizmo = tools::Tool(tool).gizmo();
    return handle_of(gizmo, sign).place;
}

// Returns the end of the parent segment, which is the gizmo's first line.
Vec2 node_of(SketchTool const& tool)
{
    return tools::Tool(tool).gizmo().lines.front().points.back();
}

class AnyRule {
public:
    explicit AnyRule(unsigned seed)
        : random_(seed)
    {
    }

    double number(double least, double greatest)
    {
        return std::uniform_real_distribution(least, greatest)(random_);
    }

    SketchTool tool()
    {
        using Card = SketchTool::Card;
        return { .card = static_cast<Card>(static_cast<int>(number(0, 8.999))),
                 .laterals = std::floor(number(0, 8.999)),
                 .angle_deg = number(0, 150),
                 .first_length_mm = number(5, 100),
                 .length_ratio = number(0.5, 1.2),
                 .lateral_length = number(0.2, 1),
                 .width_ratio = number(0.3, 1),
                 .lateral_width = number(0.2, 1),
                 .axis_twist_deg = number(-180, 180),
                 .lateral_twist_deg = number(-180, 180),
                 .shortest_mm = number(0, 5) };
    }

private:
    std::mt19937 random_;
};

// Around the lateral, the gizmo must show how much plants in a collection vary: by 12 degrees to
// both sides, and up to 12 % longer.
TEST(RuleGizmo, ShowsHowFarPlantsDiffer)
{
    SketchTool const tool { .angle_deg = 40 };
    Vec2 const node = node_of(tool);
    double const reach = (place_of_handle(tool, "A") - node).norm();
    bool is_shown = false;
    for (auto const& line : tools::Tool(tool).gizmo().lines) {
        auto const angle_deg = [&](Vec2 const& point) {
            return degrees(std::atan2(point.x() - node.x(), point.y() - node.y()));
        };
        bool const is_arc = line.points.size() > 2
            && std::abs((line.points.front() - node).norm() - 1.12 * reach) < 1e-9;
        if (!is_arc)
            continue;
        is_shown = true;
        EXPECT_NEAR(angle_deg(line.points.front()), 28, 1e-9);
        EXPECT_NEAR(angle_deg(line.points.back()), 52, 1e-9);
    }
    EXPECT_TRUE(is_shown);
}

TEST(RuleGizmo, SetsWhatAHandleIsDraggedTo)
{
    SketchTool const tool;
    Vec2 const node = node_of(tool);
    double const parent = (place_of_handle(tool, "D") - node).norm() / tool.length_ratio;
    auto const at = [&](double angle_deg, double length) {
        double const angle = radians(angle_deg);
        return Vec2(node + parent * length * Vec2(std::sin(angle), std::cos(angle)));
    };
    auto const lateral = dragged(tool, "A", at(60, 0.8));
    EXPECT_NEAR(lateral.angle_deg, 60, 1e-9);
    EXPECT_NEAR(lateral.lateral_length, 0.8, 1e-9);
    EXPECT_NEAR(dragged(tool, "A", at(-90, 0.5)).angle_deg, 90, 1e-9) << "either side";
    EXPECT_NEAR(dragged(tool, "D", at(0, 0.7)).length_ratio, 0.7, 1e-9);
    Vec2 const top = place_of_handle(tool, "D");
    auto const turned = dragged(tool, "E", top + Vec2(0.3, 0));
    EXPECT_NEAR(rule_of(turned).axis_twist_deg, 90, 1e-9);
    EXPECT_NEAR(rule_of(dragged(tool, "E", top - Vec2(0.3, 0))).axis_twist_deg, -90, 1e-9);
    Vec2 const end = place_of_handle(tool, "A");
    // The handle is dragged in the lateral's direction.
    auto const aside = dragged(tool, "B", end + (end - node));
    EXPECT_NEAR(rule_of(aside).lateral_twist_deg, 0, 1e-9);
    EXPECT_EQ(dragged(tool, "+", {}).laterals, 3);
    EXPECT_EQ(dragged(tool, "-", {}).laterals, 1);
    EXPECT_EQ(rule_of(dragged(tool, "+", {})).axis_twist_deg, 60) << "rings still alternate";
}

TEST(RuleGizmo, ComesToRestInWholeSteps)
{
    SketchTool const tool;
    Vec2 const node = node_of(tool);
    auto const at_deg = [&](double angle_deg) {
        double const angle = radians(angle_deg);
        return dragged(tool, "A", node + 0.5 * Vec2(std::sin(angle), std::cos(angle))).angle_deg;
    };
    EXPECT_NEAR(at_deg(59.2), 60, 1e-9) << "near a multiple of five";
    EXPECT_NEAR(at_deg(57.4), 57, 1e-9);
}

// However a handle is dragged, the rule must remain valid, and the tool's words must give the same
// rule.
TEST(RuleGizmo, StaysWithinTheRangesOfRules)
{
    AnyRule any(4711);
    auto const tools = methods::all_methods().tools;
    for (int i = 0; i < 1000; ++i) {
        auto const tool = any.tool();
        SCOPED_TRACE(tools::words_for(tools::Tool(tool)).arguments);
        for (auto const& handle : tools::Tool(tool).gizmo().handles) {
            auto const after
                = tools::Tool(tool).dragged(handle.id, { any.number(-3, 3), any.number(-3, 3) });
            auto const rule = rule_of(*after.get<SketchTool>());
            EXPECT_TRUE(sketch::check_rule(rule)) << handle.sign;
            auto const words = tools::words_for(after);
            EXPECT_EQ(tools::parse_tool(tools, words.name, words.arguments).value(), after);
        }
    }
}

TEST(RuleGizmo, LeavesAHandleWhereItWasPut)
{
    AnyRule any(12);
    for (int i = 0; i < 300; ++i) {
        auto const tool = any.tool();
        for (auto const& handle : tools::Tool(tool).gizmo().handles) {
            if (handle.is_button)
                continue;
            auto const once = tools::Tool(tool).dragged(handle.id, handle.place);
            for (auto const& moved : once.gizmo().handles)
                if (moved.id == handle.id) {
                    EXPECT_LT((moved.place - handle.place).norm(), 0.03) << handle.sign;
                    EXPECT_TRUE(matches_rule(*once.dragged(moved.id, moved.place).get<SketchTool>(),
                                             rule_of(*once.get<SketchTool>())))
                        << handle.sign;
                }
        }
    }
}

TEST(RuleGizmo, TakesARuleIntoTheHand)
{
    AnyRule any(5);
    for (int i = 0; i < 300; ++i) {
        auto const rule = rule_of(any.tool());
        auto const taken = with_options_of_rule(any.tool(), rule);
        EXPECT_TRUE(matches_rule(taken, rule));
        EXPECT_EQ(tools::words_for(tools::Tool(taken)).name, "sketch");
    }
}

scene::Scene two_plants_and_another(SketchTool const& tool)
{
    auto scene = scene::apply_edits(
                     scene::Scene {},
                     tools::Tool(tool)
                         .edits_for(stroke_through({ { 0, 0, 0 }, { 0, 0, 100 } }), scene::Scene {})
                         .value())
                     .value();
    auto other = tool;
    other.angle_deg = 70;
    for (auto const& next : { tool, other }) {
        auto const stroke = stroke_through({ { 50, 0, 0 }, { 50, 10, 100 } });
        scene
            = scene::apply_edits(scene, tools::Tool(next).edits_for(stroke, scene).value()).value();
    }
    return scene;
}

TEST(RuleGizmo, LetsAllThatGrewByTheRuleFollow)
{
    SketchTool const before { .laterals = 3 };
    auto after = before;
    after.lateral_twist_deg = 15;
    after.lateral_width = 0.4;
    auto const scene = two_plants_and_another(before);
    auto const edits = SketchTool::kKind.follow(tools::Tool(before), tools::Tool(after), scene);
    ASSERT_EQ(edits.size(), 2u);
    auto const changed = scene::apply_edits(scene, edits).value();
    for (std::size_t i = 0; i < 3; ++i) {
        auto const rule = sketch::newest_grown(*changed.plants[i]->drawn)->sketch->rule;
        EXPECT_EQ(matches_rule(after, rule), i < 2) << i;
        EXPECT_EQ(rule.first_width_mm, rule_of(before).first_width_mm);
    }
    after.drawn = SketchTool::Drawn::Stays;
    EXPECT_TRUE(SketchTool::kKind.follow(tools::Tool(before), tools::Tool(after), scene).empty());
}

TEST(RuleGizmo, TakesWhatThePlantWasDrawnWith)
{
    SketchTool drawn { .laterals = 5, .leaves = sketch::Leaves::Bare };
    drawn.axis_twist_deg = 20;
    auto const scene
        = scene::apply_edits(
              scene::Scene {},
              tools::Tool(drawn)
                  .edits_for(stroke_through({ { 0, 0, 0 }, { 0, 0, 100 } }), scene::Scene {})
                  .value())
              .value();
    auto const taken = SketchTool::kKind.like_drawn(tools::Tool(SketchTool {}), scene);
    ASSERT_TRUE(taken);
    EXPECT_TRUE(matches_rule(*taken->get<SketchTool>(), rule_of(drawn)));
    EXPECT_EQ(taken->get<SketchTool>()->leaves, sketch::Leaves::Bare);
    EXPECT_FALSE(SketchTool::kKind.like_drawn(tools::Tool(SketchTool {}), small_scene()));
}

} // namespace
} // namespace tractus::sketch
