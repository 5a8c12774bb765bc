#include "app/methods/sketch_lsystem/sketch_tool.h"
#include "app/tools/tool_cards.h"
#include "app/tools/tool_choices.h"

#include "app/document/document.h"
#include "app/methods/all_methods.h"
#include "app/methods/sketch_lsystem/ready_models.h"
#include "app/methods/sketch_lsystem/shorten_sketch_tool.h"
#include "app/methods/sketch_lsystem/sketch_previewer.h"
#include "app/session/edit_record.h"
#include "app/tools/bent_plant.h"
#include "engine/methods/sketch_lsystem/change_edits.h"
#include "engine/scene/scene_shaper.h"
#include "engine/variation/place_nodes.h"
#include "tests/app/replayed.h"
#include "tests/app/simulated_drawing.h"
#include "tests/app/small_model.h"

#include <gtest/gtest.h>

namespace tractus::sketch {
namespace {

Stroke rising_stroke()
{
    return stroke_through({ { 10, 0, 0 }, { 20, 10, 70 }, { 20, 40, 140 } });
}

TEST(SketchTool, SaysItsRuleInLogs)
{
    SketchTool tool { .laterals = 3, .angle_deg = 60, .leaves = sketch::Leaves::Bare };
    auto const words = tools::words_for(tool);
    EXPECT_EQ(words.name + " " + words.arguments,
              "sketch laterals=3 angle=60 first=15 ratio=0.95 lateral=0.7 bare at_foot");
    EXPECT_EQ(tools::parse_tool(methods::all_methods().tools, words.name, words.arguments).value(),
              tools::Tool(tool));
}

// Logs must contain all numbers of a chosen card, so that they keep their meaning if the card
// changes.
TEST(SketchTool, TakesAReadyRuleWithItsNumbers)
{
    auto const tools = methods::all_methods().tools;
    std::size_t plants = 0;
    std::vector<tools::Tool> chosen;
    for (auto const& card : tools::ready_cards(tools::Tool(SketchTool {})))
        chosen.push_back(card.tool);
    ASSERT_EQ(chosen.size(), 17u);
    chosen.resize(9); // The other cards are models, and the rule of the active plant.
    EXPECT_EQ(tools::words_for(chosen[1]).arguments,
              "whorls laterals=4 angle=75 first=28 ratio=0.88 at_foot");
    EXPECT_EQ(tools::words_for(chosen[5]).arguments,
              "fern angle=55 first=13 ratio=0.96 lateral=0.7 at_foot");
    EXPECT_EQ(tools::words_for(chosen[8]).arguments,
              "compound_leaf first=60 ratio=0.5 lateral=0.5 as_axis width=0.6 at_foot");
    std::vector<double> const twists_deg { 90, 45, 36, 90, 30, 0, 137.5, 180.0 / 7, 0 };
    for (auto const& tool : chosen) {
        auto const words = tools::words_for(tool);
        EXPECT_EQ(tools::parse_tool(tools, words.name, words.arguments).value(), tool);
        auto const edits = tool.edits_for(rising_stroke(), scene::Scene {}).value();
        auto const& rule = edits.front().get<sketch::GrowAlongStroke>()->rule;
        EXPECT_EQ(rule.axis_twist_deg, twists_deg[plants]);
        plants += scene::apply_edits(scene::Scene {}, edits).value().plants.size();
    }
    EXPECT_EQ(plants, 9u);
}

// Returns the edit that a stroke makes with the card of a model.
sketch::GrowAlongStroke drawn_with(SketchTool::Card card, scene::Scene const& scene = {})
{
    auto const edits
        = tools::Tool(SketchTool { .card = card }).edits_for(rising_stroke(), scene).value();
    return *edits.front().get<sketch::GrowAlongStroke>();
}

TEST(SketchTool, GrowsAModelInARulesPlace)
{
    auto const tools = methods::all_methods().tools;
    for (int card = 9; card < 16; ++card) {
        tools::Tool const tool = SketchTool { .card = static_cast<SketchTool::Card>(card) };
        auto const words = tools::words_for(tool);
        EXPECT_EQ(tools::parse_tool(tools, words.name, words.arguments).value(), tool);
        auto const grown = drawn_with(static_cast<SketchTool::Card>(card));
        auto const model = words.arguments.substr(0, words.arguments.find(' '));
        EXPECT_EQ(grown.model.source.name, model + ".l");
        auto const scene = scene::apply_edit(scene::Scene {}, grown).value();
        auto const nodes_mm = sketch::drawn_nodes_mm(grown).value();
        auto const axis_mm = scene.base->positions(scene.base->axes.front());
        ASSERT_GE(axis_mm.size(), nodes_mm.size()) << words.arguments;
        for (std::size_t i = 0; i < nodes_mm.size(); ++i)
            EXPECT_NEAR((scene.placement.world_of_plant(axis_mm[i]) - nodes_mm[i]).norm(), 0, 0.01);
        EXPECT_FALSE(tool.gizmo().lines.empty());
        EXPECT_TRUE(tool.gizmo().handles.empty());
    }
    auto const one = scene::apply_edit(scene::Scene {}, drawn_with(SketchTool::Card::Vine)).value();
    EXPECT_EQ(drawn_with(SketchTool::Card::Vine, one).model.seed, 2u) << "another one";
}

TEST(SketchTool, ShowsAModelUnderThePen)
{
    tools::Tool const tool = SketchTool { .card = SketchTool::Card::Palm };
    auto const scene = std::make_shared<scene::Scene const>(small_scene());
    auto const stroke = rising_stroke();
    auto const lines = sketch_previewer()->show({ scene, tool, stroke.tips.vector(), 99 });
    auto const after = scene::apply_edits(*scene, tool.edits_for(stroke, *scene).value()).value();
    EXPECT_EQ(lines.size(), after.base->axes.size());
}

// When another card is chosen, the plant must follow: from a rule to a model, and back.
TEST(SketchTool, ChangesRulesIntoModels)
{
    SketchTool const rule;
    SketchTool const vine { .card = SketchTool::Card::Vine };
    auto const grown = scene::apply_edits(scene::Scene {},
                                          tools::Tool(rule).edits_for(rising_stroke(), {}).value())
                           .value();
    auto const to_vine = SketchTool::kKind.follow(tools::Tool(rule), tools::Tool(vine), grown);
    ASSERT_EQ(to_vine.size(), 1u);
    auto const changed = scene::apply_edits(grown, to_vine).value();
    EXPECT_EQ(sketch::newest_grown(*changed.drawn)->sketch->model.source.name, "vine.l");
    EXPECT_EQ(SketchTool::kKind.like_drawn(tools::Tool(rule), changed)->get<SketchTool>()->card,
              SketchTool::Card::Vine);
    auto const to_rule = SketchTool::kKind.follow(tools::Tool(vine), tools::Tool(rule), changed);
    auto const back = scene::apply_edits(changed, to_rule).value();
    EXPECT_EQ(back.base->node_position_mm, grown.base->node_position_mm);
    EXPECT_TRUE(SketchTool::kKind.follow(tools::Tool(rule), tools::Tool(rule), grown).empty());
}

// The card gives the compound leaf of The Algorithmic Beauty of Plants (Ijiri 2006, figure 2): A
// --> I[+A][-A]A with internodes that double. After n steps it has 3^0 + 3^1 + ... + 3^(n-1)
// internodes, that is (3^n - 1) / 2. Each lateral is the same leaf after the remaining steps.
TEST(SketchTool, HasTheCompoundLeafAsACard)
{
    auto const card = tools::ready_cards(tools::Tool(SketchTool {}))[8].tool;
    // The stroke suffices for internodes of 60 + 30 + 15 + 7.5 mm.
    auto const stroke = stroke_through({ { 0, 0, 0 }, { 0, 0, 113 } });
    auto const scene
        = scene::apply_edits(scene::Scene {}, card.edits_for(stroke, {}).value()).value();
    auto const& plant = *scene.base;
    EXPECT_EQ(plant.segment_count(), 40u);
    auto const main_mm = plant.positions(plant.axes.front());
    ASSERT_EQ(main_mm.size(), 5u);
    for (std::size_t i = 1; i + 1 < main_mm.size(); ++i)
        EXPECT_NEAR((main_mm[i] - main_mm[i - 1]).norm(), 2 * (main_mm[i + 1] - main_mm[i]).norm(),
                    1e-3);
    for (auto const& node_mm : plant.node_position_mm)
        EXPECT_NEAR(node_mm.y(), 0, 1e-3) << "all in one plane";
    EXPECT_EQ(SketchTool::kKind.like_drawn(tools::Tool(SketchTool {}), scene)
                  ->get<SketchTool>()
                  ->go_on_by,
              SketchTool::Laterals::AsAxis);
}

// The user's own model is loaded into the tool from the plant that it made.
TEST(SketchTool, GrowsTheModelOfThePlant)
{
    scene::LoadModel own { .source = ready_model("birch").source };
    own.source.name = "own.l";
    auto const scene = scene::apply_edit(scene::Scene {}, own).value();
    auto const grown = drawn_with(SketchTool::Card::Plant, scene);
    EXPECT_EQ(grown.model.source, own.source);
    auto const both = scene::apply_edit(scene, grown).value();
    ASSERT_EQ(both.plants.size(), 2u);
    auto const nodes_mm = sketch::drawn_nodes_mm(grown).value();
    EXPECT_NEAR((both.placement.world_of_plant(both.base->positions(both.base->axes.front())[1])
                 - nodes_mm[1])
                    .norm(),
                0, 0.01);
    EXPECT_EQ(drawn_with(SketchTool::Card::Plant, both).model.source, own.source) << "and so on";
    SketchTool const any;
    EXPECT_EQ(SketchTool::kKind.like_drawn(tools::Tool(any), both)->get<SketchTool>()->card,
              SketchTool::Card::Plant);
}

// A rule that can only be written in a file is also loaded into the tool from its plant.
TEST(SketchTool, GrowsTheRuleOfThePlant)
{
    sketch::GrowAlongStroke first { .rule = { .laterals = 3 } };
    first.rule.lateral_rules = { { .laterals = 1, .laterals_by = 1 } };
    first.stroke = rising_stroke();
    first.surface = StrokeSurface::Space;
    auto const scene = scene::apply_edit(scene::Scene {}, first).value();
    EXPECT_EQ(drawn_with(SketchTool::Card::Plant, scene).rule, first.rule);
    tools::Tool const plain = SketchTool {};
    tools::Tool const of_plant = SketchTool { .card = SketchTool::Card::Plant };
    EXPECT_TRUE(SketchTool::kKind.follow(plain, of_plant, scene).empty())
        << "nothing is changed by it";
    EXPECT_TRUE(SketchTool::kKind.follow(of_plant, plain, scene).empty());
    tools::Tool const change
        = SketchTool { .card = SketchTool::Card::Plant, .place = SketchTool::Place::Change };
    EXPECT_FALSE(change.edits_for({}, scene));
}

TEST(SketchTool, RefusesAPlantThatCannotGrowAnew)
{
    tools::Tool const of_plant = SketchTool { .card = SketchTool::Card::Plant };
    auto const refused = of_plant.edits_for(rising_stroke(), scene::Scene {});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("neither from a rule nor from a model"),
              std::string::npos);
    EXPECT_TRUE(sketch_previewer()
                    ->show({ std::make_shared<scene::Scene const>(), of_plant,
                             rising_stroke().tips.vector(), 9 })
                    .empty());
}

// Edits with rules must be written to sessions as before, without the fields of models.
TEST(SketchTool, KeepsNothingOfModelsWithRules)
{
    auto const fields_of = [](scene::Edit const& edit) { return session::record_of(edit).fields; };
    for (auto const& fields :
         { fields_of(sketch::GrowAlongStroke {}), fields_of(sketch::ChangeSketch {}) })
        for (auto const* const name : { "model", "view", "includes", "seed" })
            EXPECT_EQ(fields.find(name), std::string::npos) << fields;
    auto const grown = drawn_with(SketchTool::Card::Vine);
    auto const read
        = session::edit_of(session::record_of(grown), methods::all_methods().edits).value();
    EXPECT_EQ(read.get<sketch::GrowAlongStroke>()->model, grown.model);
}

// A log must contain only the name of a model, not its text.
TEST(SketchTool, GrowsTheSameModelFromALog)
{
    constexpr std::string_view kVine = R"(
version = 1
seed = 3
[[gesture]]
tool = "sketch"
words = "vine space"
path = "s_curve"
from_mm = [16, 20, 34]
to_mm = [70, 0, 95]
swing_mm = 12
speed_mm_s = 120
)";
    auto const log = recorded_log(kVine);
    auto const one = replayed(log).scene;
    auto const two = replayed(log).scene;
    ASSERT_EQ(one.plants.size(), 2u);
    auto const* const grown = sketch::newest_grown(*one.drawn)->sketch;
    EXPECT_EQ(grown->model.source.name, "vine.l");
    EXPECT_EQ(grown->model.seed, 2u);
    EXPECT_EQ(one.base->node_position_mm, two.base->node_position_mm);
}

// A log of an older version names only the numbers that differed from the defaults of that version.
TEST(SketchTool, KeepsTheNumbersOfOlderLogs)
{
    auto const tools = methods::all_methods().tools;
    auto const older = tools::parse_tool(tools, "sketch", "laterals=3").value();
    auto const& numbers = *older.get<SketchTool>();
    EXPECT_EQ(numbers.laterals, 3);
    EXPECT_EQ(numbers.angle_deg, 45);
    EXPECT_EQ(numbers.first_length_mm, 30);
    EXPECT_EQ(numbers.length_ratio, 0.9);
    EXPECT_EQ(numbers.lateral_length, 0.62);
    EXPECT_EQ(tools::words_for(older).arguments, "laterals=3");
}

// If a card's number is set back to the default of the tool, it still counts as set by the user.
TEST(SketchTool, KeepsNumbersThatArePutBackBesideACard)
{
    SketchTool const tool { .card = SketchTool::Card::Whorls, .laterals = 2 };
    auto const words = tools::words_for(tool);
    EXPECT_EQ(words.arguments, "whorls angle=50 first=15 ratio=0.95 lateral=0.7 at_foot");
    EXPECT_EQ(tools::parse_tool(methods::all_methods().tools, words.name, words.arguments).value(),
              tools::Tool(tool));
}

TEST(SketchTool, DrawsAStrokeAgain)
{
    SketchTool tool { .laterals = 3 };
    auto const scene
        = scene::apply_edits(scene::Scene {},
                             tools::Tool(tool).edits_for(rising_stroke(), scene::Scene {}).value())
              .value();
    tool.place = SketchTool::Place::Again;
    tool.laterals = 5; // Drawing the stroke again must keep the plant's own rule.
    auto const stroke = stroke_through({ { 0, 0, 0 }, { 0, 0, 150 }, { 60, 0, 200 } });
    auto const edits = tools::Tool(tool).edits_for(stroke, scene).value();
    ASSERT_EQ(edits.size(), 1u);
    auto const again = scene::apply_edits(scene, edits).value();
    ASSERT_EQ(again.plants.size(), 1u);
    auto const* const grown = sketch::newest_grown(*again.drawn)->sketch;
    EXPECT_EQ(grown->rule.laterals, 3);
    EXPECT_EQ(grown->stroke.tips.vector().size(), stroke.tips.vector().size());
    EXPECT_FALSE(tools::Tool(tool).edits_for(stroke, small_scene()))
        << "nothing has grown along a stroke";
    auto const preview = sketch_previewer();
    auto const ink = stroke.tips.vector();
    EXPECT_FALSE(
        preview->show({ std::make_shared<scene::Scene const>(scene), tools::Tool(tool), ink, 9 })
            .empty());
    EXPECT_TRUE(preview
                    ->show({ std::make_shared<scene::Scene const>(small_scene()), tools::Tool(tool),
                             ink, 9 })
                    .empty());
}

TEST(SketchTool, AddsAPlantInTheDocumentsScale)
{
    tools::Tool const tool = SketchTool {};
    auto const alone = tool.edits_for(rising_stroke(), scene::Scene {}).value();
    auto const* const first = alone.front().get<sketch::GrowAlongStroke>();
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first->scale, 0.1);
    EXPECT_EQ(first->surface, StrokeSurface::Space);
    auto const scene = small_scene();
    auto const beside = tool.edits_for(rising_stroke(), scene).value();
    EXPECT_EQ(beside.front().get<sketch::GrowAlongStroke>()->scale, scene.placement.scale);
    auto const both = scene::apply_edits(scene, beside).value();
    ASSERT_EQ(both.plants.size(), 2u);
    EXPECT_EQ(both.plants[0], scene.plants[0]) << "it stays as it was";
}

// The plant shown while the pen draws must be equal to the plant that results.
TEST(SketchTool, ShowsThePlantThatItWillGrow)
{
    tools::Tool const tool = SketchTool { .leaves = sketch::Leaves::Bare };
    auto const scene = std::make_shared<scene::Scene const>(small_scene());
    auto const stroke = rising_stroke();
    auto const lines = sketch_previewer()->show({ scene, tool, stroke.tips.vector(), 99 });
    auto const after = scene::apply_edits(*scene, tool.edits_for(stroke, *scene).value()).value();
    ASSERT_EQ(lines.size(), after.base->axes.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        auto const nodes_mm = after.base->positions(after.base->axes[i]);
        ASSERT_EQ(lines[i].points_mm.size(), nodes_mm.size());
        for (std::size_t k = 0; k < nodes_mm.size(); ++k) {
            Vec3 const shown_mm
                = scene->placement.world_of_plant(lines[i].points_mm[k].cast<double>());
            EXPECT_NEAR((shown_mm - after.placement.world_of_plant(nodes_mm[k])).norm(), 0, 0.05);
        }
    }
    auto const too_short = stroke_through({ { 0, 0, 0 }, { 5, 0, 0 } });
    EXPECT_TRUE(sketch_previewer()->show({ scene, tool, too_short.tips.vector(), 99 }).empty());
}

// There is no message while the preview shows the whole plant.
TEST(SketchTool, SaysWhatAPreviewLeavesOut)
{
    auto const scene = std::make_shared<scene::Scene const>(small_scene());
    auto const previewer = sketch_previewer();
    auto const note = [&](SketchTool const& tool, Vec3 const& end_mm) {
        auto const stroke = stroke_through({ { 0, 0, 0 }, end_mm });
        EXPECT_FALSE(previewer->show({ scene, tool, stroke.tips.vector(), 99 }).empty());
        return previewer->note();
    };
    SketchTool const forking { .first_length_mm = 8, .length_ratio = 1, .lateral_length = 0.9 };
    EXPECT_EQ(note(forking, { 0, 0, 30 }), "");
    EXPECT_EQ(note(forking, { 0, 0, 110 }), "The finest forks come when the pen is lifted");
    EXPECT_EQ(note(forking, { 0, 0, 240 }),
              "Laterals fork at most 12 times: more were over 200000 internodes; the finest come "
              "when the pen is lifted");
    auto const rule = grown_along(forking, rising_stroke(), *scene)->rule;
    EXPECT_LE(sketch::count_internodes(rule, 30, 12), 200'000);
    EXPECT_GT(sketch::count_internodes(rule, 30, 13), 200'000);
    EXPECT_EQ(note({ .card = SketchTool::Card::Conifer }, { 0, 0, 1500 }),
              "The axis alone is shown while you draw");
    EXPECT_EQ(note(forking, { 0, 0, 30 }), "") << "it is about the last one";
}

// Compares the lines of the preview with the plant of the finished stroke. If the stroke makes a
// part, the axes before `first` are those of the plant on which the part grows. The stem of the
// part begins on its branch, which the pen need not have met, so its first node is not compared.
void expect_shown(scene::Scene const& scene, tools::Tool const& tool, Stroke const& stroke,
                  std::size_t first)
{
    auto const shared = std::make_shared<scene::Scene const>(scene);
    auto const lines = sketch_previewer()->show({ shared, tool, stroke.tips.vector(), 99 });
    auto const after = scene::apply_edits(scene, tool.edits_for(stroke, scene).value()).value();
    ASSERT_EQ(lines.size(), after.base->axes.size() - first);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        auto const nodes_mm = after.base->positions(after.base->axes[first + i]);
        ASSERT_EQ(lines[i].points_mm.size(), nodes_mm.size());
        for (std::size_t k = i == 0 ? 1 : 0; k < nodes_mm.size(); ++k) {
            Vec3 const shown_mm
                = scene.placement.world_of_plant(lines[i].points_mm[k].cast<double>());
            EXPECT_NEAR((shown_mm - after.placement.world_of_plant(nodes_mm[k])).norm(), 0, 0.05)
                << i << ", " << k;
        }
    }
}

Stroke from(Vec3 const& at_mm)
{
    return stroke_through({ at_mm, at_mm + Vec3(20, 20, 60), at_mm + Vec3(10, 30, 140) });
}

TEST(SketchTool, GrowsOnTheBranchWhereTheStrokeBegins)
{
    auto const scene = small_scene();
    auto const node = nodes_of(*scene.base, 7).tip;
    Vec3 const end_mm = scene.placement.world_of_plant(scene.base->node_position_mm[node]);
    tools::Tool const tool
        = SketchTool { .leaves = sketch::Leaves::Bare, .place = SketchTool::Place::Branch };
    for (auto const& off_mm : { Vec3(2, -1, 3), Vec3(1, 1, 25) }) {
        auto const stroke = from(end_mm + off_mm);
        auto const after = scene::apply_edits(scene, tool.edits_for(stroke, scene).value()).value();
        ASSERT_EQ(after.plants.size(), 1u);
        EXPECT_EQ(after.base->axes[3].parent_segment, 7u);
        EXPECT_EQ(after.placement.scale, scene.placement.scale);
        expect_shown(scene, tool, stroke, 3);
    }
    auto const flat = stroke_through({ end_mm, end_mm + Vec3(90, 60, 0) });
    auto const level = scene::apply_edits(scene, tool.edits_for(flat, scene).value()).value();
    EXPECT_EQ(level.base->axes[3].parent_segment, 7u) << "in space, as the pad shows the branch";
    auto const& radii_mm = level.base->node_radius_mm;
    double const first_mm = 2 * scene.placement.scale * radii_mm[level.base->axes[3].first_node];
    double const parent_mm = 2 * scene.placement.scale * radii_mm[node];
    EXPECT_LE(first_mm, std::max(parent_mm, 0.0201 * 30)) << "as thin as a rule can be";
    EXPECT_FALSE(tool.edits_for(from({ 0, 300, 0 }), scene)) << "no branch there";
    EXPECT_FALSE(tool.edits_for(from(end_mm + Vec3(0, 0, 60)), scene)) << "far below";
    EXPECT_FALSE(tool.edits_for(from({ 0, 0, 0 }), scene::Scene {})) << "no plant at all";
}

// A stroke begins on a branch that another stroke has bent. The new branch must be where it was
// drawn.
TEST(SketchTool, GrowsOnWhatStrokesHaveBent)
{
    auto scene = small_scene();
    select(scene, { { 0, 1, 2, 3, 4, 5 } });
    scene = scene::apply_edit(scene,
                              scene::Associate { stroke_through({ { 0, 0, 0 }, { 90, 0, 60 } }),
                                                 variation::Propagation::Selected,
                                                 variation::StrokeFit::World })
                .value();
    tools::Tool const tool
        = SketchTool { .leaves = sketch::Leaves::Bare, .place = SketchTool::Place::Branch };
    double const height_mm = 6 * 100 * scene.placement.scale;
    Vec3 const end_mm = Vec3(90, 0, 60).normalized() * height_mm;
    auto const stroke = from(end_mm);
    auto const after = scene::apply_edits(scene, tool.edits_for(stroke, scene).value()).value();
    scene::SceneShaper shaper;
    ASSERT_TRUE(shaper.set_plant(after));
    std::vector<Vec3> nodes_mm;
    variation::place_nodes(*after.base, *after.rest, shaper.shape(), nodes_mm);
    auto const alone = scene::apply_edits(scene,
                                          tools::Tool(SketchTool { .leaves = sketch::Leaves::Bare })
                                              .edits_for(stroke, scene)
                                              .value())
                           .value();
    auto const& drawn = alone.base->axes[0];
    auto const& grown = after.base->axes[3];
    ASSERT_EQ(grown.parent_segment, 5u);
    ASSERT_EQ(grown.segment_count, drawn.segment_count);
    for (std::size_t k = 0; k <= grown.segment_count; ++k) {
        Vec3 const wanted_mm = alone.placement.world_of_plant(alone.base->positions(drawn)[k]);
        Vec3 const seen_mm = after.placement.world_of_plant(nodes_mm[grown.first_node + k]);
        EXPECT_NEAR((seen_mm - wanted_mm).norm(), 0, 0.5) << k;
    }
}

TEST(SketchTool, GrowsInThePlaceOfABranch)
{
    auto const scene = small_scene();
    auto const node = nodes_of(*scene.base, 7).tip;
    Vec3 const end_mm = scene.placement.world_of_plant(scene.base->node_position_mm[node]);
    tools::Tool const tool = SketchTool { .laterals = 0, .place = SketchTool::Place::InPlace };
    auto const after
        = scene::apply_edits(scene, tool.edits_for(from(end_mm), scene).value()).value();
    ASSERT_EQ(after.plants.size(), 1u);
    ASSERT_EQ(after.base->axes.size(), 3u) << "the trunk, the other branch and what was drawn";
    EXPECT_EQ(after.base->axes[2].parent_segment, scene.base->axes[1].parent_segment);
    EXPECT_EQ(after.drawn->hidden_branches.size(), 1u);
}

TEST(SketchTool, ChangesWhatHasGrownAtOnce)
{
    tools::Tool const draws = SketchTool { .leaves = sketch::Leaves::Bare };
    auto const scene
        = scene::apply_edits(small_scene(), draws.edits_for(rising_stroke(), small_scene()).value())
              .value();
    tools::Tool const changes = SketchTool { .laterals = 4,
                                             .leaves = sketch::Leaves::Bare,
                                             .place = SketchTool::Place::Change };
    EXPECT_TRUE(changes.needs_no_stroke());
    auto const after = scene::apply_edits(scene, changes.edits_for({}, scene).value()).value();
    tools::Tool const four = SketchTool { .laterals = 4, .leaves = sketch::Leaves::Bare };
    auto const drawn
        = scene::apply_edits(small_scene(), four.edits_for(rising_stroke(), small_scene()).value())
              .value();
    EXPECT_EQ(after.base->node_position_mm, drawn.base->node_position_mm);
    EXPECT_FALSE(changes.edits_for({}, small_scene())) << "that one has not grown along a stroke";
}

TEST(SketchTool, LetsLateralsGoOnByARuleOfTheirOwn)
{
    SketchTool options { .leaves = sketch::Leaves::Bare };
    options.go_on_by = SketchTool::Laterals::Fern;
    tools::Tool const tool = options;
    auto const words = tools::words_for(tool);
    EXPECT_EQ(words.name + " " + words.arguments,
              "sketch angle=50 first=15 ratio=0.95 lateral=0.7 by_fern bare at_foot");
    EXPECT_EQ(tools::parse_tool(methods::all_methods().tools, words.name, words.arguments).value(),
              tool);
    auto const forks = scene::apply_edits({},
                                          tools::Tool(SketchTool { .leaves = sketch::Leaves::Bare })
                                              .edits_for(rising_stroke(), {})
                                              .value());
    auto const goes_on
        = scene::apply_edits({}, tool.edits_for(rising_stroke(), {}).value()).value();
    // The drawn axis is the same as with forks, but its laterals have several internodes.
    auto const& axes = goes_on.base->axes;
    EXPECT_EQ(axes[0].segment_count, forks->base->axes[0].segment_count);
    auto const longest = std::max_element(axes.begin() + 1, axes.end(), [](auto& a, auto& b) {
        return a.segment_count < b.segment_count;
    });
    EXPECT_EQ(longest->segment_count, axes[0].segment_count - 1);
    // The setting `go_on_by` is kept if other numbers change, and is loaded into the tool with the
    // rule.
    auto faster = options;
    faster.angle_deg = 60;
    auto const followed
        = scene::apply_edits(goes_on, SketchTool::kKind.follow(tool, tools::Tool(faster), goes_on))
              .value();
    auto const taken = SketchTool::kKind.like_drawn(tools::Tool(SketchTool {}), followed);
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->get<SketchTool>()->go_on_by, SketchTool::Laterals::Fern);
    EXPECT_EQ(taken->get<SketchTool>()->angle_deg, 60);
}

TEST(ShortenSketchTool, TakesTheEndAwayWhereItRunsOverTheAxis)
{
    tools::Tool const draws = SketchTool { .leaves = sketch::Leaves::Bare };
    auto const stroke = stroke_through({ { 0, 0, 0 }, { 100, 40, 60 } });
    auto const scene = scene::apply_edits({}, draws.edits_for(stroke, {}).value()).value();
    auto const whole = scene.base->axes[0].segment_count;
    ASSERT_GE(whole, 3u);
    auto const middle_mm = tools::BentPlant(scene).begin_of(1);
    auto const end_mm = tools::BentPlant(scene).end_of(1);
    Vec3 const at_mm = (middle_mm + end_mm) / 2;
    tools::Tool const tool = ShortenSketchTool {};
    auto const across = [](Vec3 const& place_mm) {
        return stroke_through({ place_mm - Vec3(3, -6, 0), place_mm + Vec3(3, -6, 0) });
    };
    auto const after
        = scene::apply_edits(scene, tool.edits_for(across(at_mm), scene).value()).value();
    EXPECT_EQ(after.base->axes[0].segment_count, 1u);
    EXPECT_FALSE(tool.edits_for(across({ 0, 0, 0 }), scene)) << "nothing would be left";
    EXPECT_FALSE(tool.edits_for(across({ 0, 300, 0 }), scene));
    EXPECT_FALSE(tool.edits_for(across({ 0, 0, 50 }), small_scene()));
}

// Strokes of this tool must be undone, redone and replayed like those of any other tool.
TEST(SketchTool, IsUndoneAndDoneAgain)
{
    document::Document document(small_scene(), document::Document::Working::AtOnce);
    document.draw({ rising_stroke(), SketchTool {} });
    auto const drawn = document.newest();
    ASSERT_EQ(drawn->scene.plants.size(), 2u);
    document.undo();
    EXPECT_EQ(document.newest()->scene.plants.size(), 1u);
    EXPECT_EQ(document.newest()->scene.base->segment_count(), 12u);
    document.redo();
    ASSERT_EQ(document.newest()->scene.plants.size(), 2u);
    EXPECT_EQ(document.newest()->scene.base->node_position_mm, drawn->scene.base->node_position_mm);
}

} // namespace
} // namespace tractus::sketch
