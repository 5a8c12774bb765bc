#include "app/methods/silhouettes/outline_meaning.h"
#include "app/methods/silhouettes/outline_tool.h"

#include "app/document/document.h"
#include "app/methods/all_methods.h"
#include "app/methods/construction_lines/line_tool.h"
#include "app/methods/fill_crown_tool.h"
#include "app/methods/leaves/leaf_line_tool.h"
#include "app/methods/self_organising/growth_brush_tool.h"
#include "app/methods/silhouettes/arrange_tool.h"
#include "app/methods/silhouettes/crown_tool.h"
#include "app/methods/silhouettes/erase_outline_tool.h"
#include "app/methods/silhouettes/outline_layer.h"
#include "app/methods/silhouettes/outline_previewer.h"
#include "app/methods/sketch_lsystem/sketch_tool.h"
#include "app/session/edit_record.h"
#include "app/tools/draw_in_order_tool.h"
#include "app/tools/draw_tool.h"
#include "app/tools/limb_tool.h"
#include "engine/methods/silhouettes/tree_preset.h"
#include "tests/app/methods/silhouettes/drawn_trees.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace tractus::silhouette {
namespace {

using namespace drawn_trees;
using silhouette::DrawTree;

TEST(OutlineTool, SaysItsNumbersInLogs)
{
    OutlineTool const tool { .levels = 1, .leaves = 8, .what = OutlineTool::What::New };
    auto const words = tools::words_for(tool);
    EXPECT_EQ(
        words.name + " " + words.arguments,
        "outline levels=1 leaves=8 new of_any siblings foot_first whole_nodes fills_by_species");
    EXPECT_EQ(tools::parse_tool(methods::all_methods().tools, words.name, words.arguments).value(),
              tools::Tool(tool));
}

// Returns a stroke that begins in the middle of the branch of the crown's upper right lobe.
Stroke line_from_branch(silhouette::OutlinedTree const& tree)
{
    auto const skeleton = silhouette::skeleton_of(tree).value();
    auto const& branches = skeleton.systems[0].branches;
    auto const lobe = std::min_element(branches.begin(), branches.end(), [](auto& a, auto& b) {
        Vec2 const middle(19, 29);
        return (a.path.curve.end - middle).norm() < (b.path.curve.end - middle).norm();
    });
    Vec2 const from = lobe->path.curve.at(0.6);
    std::vector<Vec3> places;
    for (int i = 0; i <= 8; ++i)
        places.emplace_back(from.x() + 0.5 * i, from.y() + 1.2 * i, 150);
    return stroke_through(places);
}

// Returns the tool as it was in old logs, in which a line could not be a branch of a branch.
OutlineTool tool_of_old_logs()
{
    return { .branches = OutlineTool::Branches::OfTrunk,
             .style = silhouette::StyleScope::None,
             .reads = OutlineTool::Reads::AsAtFirst,
             .nodes = NodesOption::AsAtFirst,
             .fills = FillsOption::AsAtFirst };
}

TEST(OutlineTool, MeansInOldLogsWhatItMeantThen)
{
    auto const tools = methods::all_methods().tools;
    EXPECT_EQ(tools::parse_tool(tools, "outline", "").value(), tools::Tool(tool_of_old_logs()));
    EXPECT_EQ(tools::words_for(tool_of_old_logs()).arguments, "");
    // In old logs, lines could only be drawn on the branches of the trunk.
    auto const of_branches = tools::parse_tool(tools, "outline", "of_nearest siblings").value();
    EXPECT_EQ(of_branches,
              tools::Tool(OutlineTool { .branches = OutlineTool::Branches::OfNearest,
                                        .reads = OutlineTool::Reads::AsAtFirst,
                                        .nodes = NodesOption::AsAtFirst,
                                        .fills = FillsOption::AsAtFirst }));
    auto const tree = crowned();
    auto const line = line_from_branch(*silhouette::outlined_tree(*tree.drawn));
    EXPECT_EQ(meant(line, tree, *of_branches.get<OutlineTool>()).search,
              silhouette::Search::OnTrunk);
    // Without arguments, as in old logs, these tools differ from their present defaults: crowns had
    // incomplete nodes and were not filled by spacing, plants did not stand at the foot of a
    // stroke, rules had longer internodes, trees of a habit had no annual rings, construction
    // lines had other depths and were read one by one, leaves were simple, and strokes were neither
    // laid by heading nor reversed if they were drawn from tip to foot. All other tools have the
    // same defaults.
    using Brush = self_organising::GrowthBrushTool;
    constexpr auto kMinTwist = variation::StrokeLaying::LeastTwist;
    constexpr auto kAsDrawn = tools::StrokeBase::AsDrawn;
    for (auto const* const kind : tools) {
        auto const begun = kind == &OutlineTool::kKind ? tools::Tool(tool_of_old_logs())
            : kind == &CrownTool::kKind                ? tools::Tool(
                                 CrownTool { .nodes = NodesOption::AsAtFirst, .fills = FillsOption::AsAtFirst })
            : kind == &sketch::SketchTool::kKind
            ? tools::Tool(sketch::SketchTool { .angle_deg = 45,
                                               .first_length_mm = 30,
                                               .length_ratio = 0.9,
                                               .lateral_length = 0.62,
                                               .stands = sketch::SketchTool::Stands::AsDrawn })
            : kind == &Brush::kKind
            ? tools::Tool(Brush { .edition = Brush::Edition::Pipe, .base = kAsDrawn })
            : kind == &methods::FillCrownTool::kKind
            ? tools::Tool(methods::FillCrownTool { .edition = Brush::Edition::Pipe })
            : kind == &leaf::LeafLineTool::kKind
            ? tools::Tool(leaf::LeafLineTool { .leaves = leaf::LeafLineTool::Leaves::Simple })
            : kind == &lines::LineTool::kKind ? tools::Tool(lines::LineTool {
                  .depth_by = lines::DepthBy::StemsHeight, .reading = lines::Reading::OneByOne })
            : kind == &tools::DrawTool::kKind
            ? tools::Tool(tools::DrawTool { .laying = kMinTwist, .base = kAsDrawn })
            : kind == &tools::DrawInOrderTool::kKind
            ? tools::Tool(tools::DrawInOrderTool { .laying = kMinTwist, .base = kAsDrawn })
            : kind == &tools::LimbTool::kKind ? tools::Tool(tools::LimbTool { .base = kAsDrawn })
                                              : tools::Tool(*kind);
        EXPECT_EQ(tools::parse_tool(tools, kind->word, "").value(), begun) << kind->word;
    }
}

// Each word for a form in the tool must name one of the ready-made forms.
TEST(OutlineTool, TakesAReadyFormWithItsNumbers)
{
    auto const tools = methods::all_methods().tools;
    auto const outlined = after(after({}, trunk_at(0)), crown_around(0, 10));
    silhouette::FormTree styled { .plant = outlined.state.active, .form = {} };
    styled.form.styles[0] = { .children = 12,
                              .unbranched = 0.2,
                              .spacing = 0.05,
                              .first_angle_deg = 50,
                              .last_angle_deg = 40 };
    // Choosing a ready-made form also replaces the style of the tree.
    auto const scene = scene::apply_edit(outlined, styled).value();
    for (auto const& ready : silhouette::tree_presets()) {
        tools::Tool tool = OutlineTool {};
        auto const words = tools::word_settings(tool)[0].option.words;
        for (std::size_t i = 0; i < words.size(); ++i)
            if (words[i].word == ready.name)
                tool = tools::with_word(tool, 0, static_cast<int>(i));
        ASSERT_FALSE(tool == tools::Tool(OutlineTool {})) << ready.name;
        auto const said = tools::words_for(tool);
        EXPECT_EQ(tools::parse_tool(tools, said.name, said.arguments).value(), tool);
        auto form = ready.form;
        form.has_whole_nodes = true;
        form.leaves_reach_outline = ready.name != std::string("fern");
        form.bases_by_angle = ready.name != std::string("fern");
        EXPECT_EQ(meant(trunk_at(0), {}, *tool.get<OutlineTool>()).form, form) << ready.name;
        auto given = *tool.get<OutlineTool>();
        given.what = OutlineTool::What::Form;
        auto const edits = tools::Tool(given).edits_for({}, scene).value();
        EXPECT_EQ(edits[0].get<silhouette::FormTree>()->form, form) << ready.name;
        EXPECT_TRUE(scene::apply_edits(scene, edits)) << ready.name;
    }
}

// Setting only the number of leaves must not change the rest of a form, such as a pine's narrow
// needles.
TEST(OutlineTool, LeavesTheFormOfATreeToWhoGivesNumbersAlone)
{
    auto const pine = after({}, trunk_at(0), { .form = OutlineTool::Form::Pine });
    OutlineTool const more { .leaves = 60, .what = OutlineTool::What::Form };
    auto const edits = tools::Tool(more).edits_for({}, pine).value();
    auto const& form = edits[0].get<silhouette::FormTree>()->form;
    EXPECT_EQ(form.leaves, 60);
    EXPECT_EQ(form.leaf_width, 0.05);
    EXPECT_EQ(form.patterns[0], silhouette::Pattern::Whorls);
}

TEST(OutlineTool, TellsTrunkOutlineAndBranchByHowTheyLie)
{
    auto const stem = after({}, trunk_at(10));
    EXPECT_EQ(meant(trunk_at(10), {}).part, DrawTree::Part::Trunk);
    EXPECT_EQ(meant(trunk_at(10), {}).stands_at_mm, Vec3(10, 0, 0));
    auto const outline = meant(crown_around(10, 10), stem);
    EXPECT_EQ(outline.part, DrawTree::Part::Outline);
    EXPECT_EQ(outline.plant, stem.state.active);
    auto const tree = after(stem, crown_around(10, 10));
    auto const branch = meant(stroke_through({ { 11, -10, 0 }, { 20, 0, 0 }, { 34, 4, 0 } }), tree);
    EXPECT_EQ(branch.part, DrawTree::Part::Branch);
    EXPECT_EQ(branch.plant, tree.state.active);
    auto const again = meant(trunk_at(12), tree);
    EXPECT_EQ(again.part, DrawTree::Part::Trunk);
    EXPECT_EQ(again.plant, tree.state.active) << "it begins at the foot";
    EXPECT_EQ(meant(crown_around(12, 8), tree).plant, tree.state.active)
        << "a crown over the old one is drawn anew";
}

TEST(OutlineTool, TellsABranchsOwnOutlineByWhatItLiesAround)
{
    auto const stem = after({}, trunk_at(0));
    EXPECT_EQ(meant(lobe_of_crown(), stem).part, DrawTree::Part::Outline) << "there is no crown";
    auto const tree = after(stem, crown_around(0, 10));
    for (double const size : { 0.9, 1.0, 1.2 }) {
        auto const own = meant(lobe_of_crown(size), tree);
        EXPECT_EQ(own.part, DrawTree::Part::OwnOutline) << size;
        EXPECT_EQ(own.plant, tree.state.active);
    }
    auto const refined = after(tree, lobe_of_crown());
    EXPECT_EQ(meant(lobe_of_crown(1.1), refined).part, DrawTree::Part::OwnOutline);
    for (auto const& scene : { tree, refined })
        EXPECT_EQ(meant(crown_around(1, 8), scene).part, DrawTree::Part::Outline);
    OutlineTool const another { .what = OutlineTool::What::New };
    EXPECT_EQ(meant(lobe_of_crown(), tree, another).part, DrawTree::Part::Outline);
}

TEST(OutlineTool, TellsABranchOnABranchByWhereItBegins)
{
    auto const tree = crowned();
    auto const line = line_from_branch(*silhouette::outlined_tree(*tree.drawn));
    auto const own = meant(line, tree);
    EXPECT_EQ(own.part, DrawTree::Part::OwnBranch);
    EXPECT_EQ(own.style_to, silhouette::StyleScope::Siblings);
    auto const old = meant(line, tree, tool_of_old_logs());
    EXPECT_EQ(old.part, DrawTree::Part::Branch) << "as logs have it";
    EXPECT_EQ(old.style_to, silhouette::StyleScope::None);
    auto const on_trunk = stroke_through({ { 1, -10, 0 }, { 12, 0, 0 }, { 26, 4, 0 } });
    EXPECT_EQ(meant(on_trunk, tree).part, DrawTree::Part::Branch);
    EXPECT_EQ(meant(lobe_of_crown(), tree).style_to, silhouette::StyleScope::Siblings);
}

// Drawing, undoing, redoing and erasing a branch of a branch must give the same plants at each
// step.
TEST(OutlineTool, DrawsABranchOnABranch)
{
    document::Document document({}, document::Document::Working::AtOnce);
    for (auto const& stroke : { trunk_at(0), crown_around(0, 10) })
        document.draw({ stroke, OutlineTool {} });
    auto const tree = [&] { return *silhouette::outlined_tree(*document.newest()->scene.drawn); };
    auto const nodes = [&] { return document.newest()->scene.base->node_position_mm; };
    auto const before = nodes();
    auto const line = line_from_branch(tree());
    document.draw({ line, OutlineTool {} });
    ASSERT_EQ(tree().own_branches.size(), 1u);
    auto const said = OutlineTool::kKind.describe(OutlineTool {}, document.newest()->scene);
    EXPECT_EQ(said, "The branch bears 1 branch that you drew; its siblings follow");
    auto const drawn = nodes();
    EXPECT_NE(drawn, before);
    EXPECT_EQ(kTrunkLayer.lines(document.newest()->scene).size(), 2u);
    document.undo();
    EXPECT_EQ(nodes(), before);
    document.redo();
    EXPECT_EQ(nodes(), drawn);
    auto const& end = line.tips.vector().back().position_mm;
    document.draw(
        { stroke_through({ { end.x() - 3, end.y() - 1, 0 }, { end.x() + 3, end.y(), 0 } }),
          EraseOutlineTool {} });
    EXPECT_TRUE(tree().own_branches.empty());
    EXPECT_EQ(nodes(), before);
}

// The style of the outlined lobe is carried to the lobe at the upper left, and undone. The edit
// must be the same after it is written and read.
TEST(OutlineTool, CarriesAStyle)
{
    document::Document document({}, document::Document::Working::AtOnce);
    for (auto const& stroke : { trunk_at(0), crown_around(0, 10), lobe_of_crown() })
        document.draw({ stroke, OutlineTool { .style = silhouette::StyleScope::None } });
    OutlineTool const carrying { .what = OutlineTool::What::Carry };
    auto const words = tools::words_for(carrying);
    EXPECT_EQ(words.arguments, "carry of_any siblings foot_first whole_nodes fills_by_species");
    EXPECT_EQ(tools::parse_tool(methods::all_methods().tools, words.name, words.arguments).value(),
              tools::Tool(carrying));
    auto const tree = [&] { return *silhouette::outlined_tree(*document.newest()->scene.drawn); };
    auto const nodes = [&] { return document.newest()->scene.base->node_position_mm; };
    auto const before = nodes();
    auto const source = tree().own_outlines[0].branch;
    auto const skeleton = silhouette::skeleton_of(tree()).value();
    Vec2 const from = skeleton.systems[0].branches[skeleton.at(source)->branch].path.curve.at(0.8);
    auto const line = stroke_through({ { from.x(), from.y(), 0 }, { -19, 29, 0 } });
    auto const edits = tools::Tool(carrying).edits_for(line, document.newest()->scene).value();
    ASSERT_EQ(edits.size(), 1u);
    auto const& styles = edits[0].get<silhouette::ChooseStyles>()->styles;
    ASSERT_GE(styles.size(), 1u);
    EXPECT_EQ(styles.begin()->second, source);
    auto const again
        = session::edit_of(session::record_of(edits[0]), methods::all_methods().edits).value();
    EXPECT_EQ(again.get<silhouette::ChooseStyles>()->styles, styles);
    auto const scene = std::make_shared<scene::Scene const>(document.newest()->scene);
    tools::Tool const tool = carrying;
    EXPECT_EQ(outline_previewer()->show({ scene, tool, line.tips.vector(), 99 }).size(),
              styles.size() + 1)
        << "the source and its targets";
    document.draw({ line, carrying });
    EXPECT_EQ(tree().styles, styles);
    auto const carried = nodes();
    EXPECT_NE(carried, before);
    EXPECT_NE(OutlineTool::kKind.describe(carrying, document.newest()->scene).find("the style of"),
              std::string::npos);
    document.undo();
    EXPECT_EQ(nodes(), before);
    document.redo();
    EXPECT_EQ(nodes(), carried);
    EXPECT_FALSE(tools::Tool(carrying).edits_for(trunk_at(0), small_scene()))
        << "no tree with an outline";
}

// A line can be drawn on a branch that was itself drawn on a branch. New logs contain the option
// for this. In old logs, the tool does not search for such branches.
TEST(OutlineTool, DrawsOnBranchesOfBranches)
{
    OutlineTool const alone { .style = silhouette::StyleScope::None };
    auto tree = crowned();
    Vec3 const base = line_from_branch(*silhouette::outlined_tree(*tree.drawn)).tips[0].position_mm;
    std::vector<Vec3> places; // A line across the branch, which rises to the right.
    for (int i = 0; i <= 8; ++i)
        places.push_back(base + i * Vec3(-0.7, 1, 0));
    tree = after(tree, stroke_through(places), alone);
    auto const& parent = silhouette::outlined_tree(*tree.drawn)->own_branches[0].branch;
    Vec3 const from = places[6];
    auto const twig = stroke_through({ from, from + Vec3(2, 2, 0), from + Vec3(3, 5, 0) });
    auto const own = meant(twig, tree, alone);
    EXPECT_EQ(own.part, DrawTree::Part::OwnBranch);
    EXPECT_EQ(own.search, silhouette::Search::AnyLevel);
    auto const again
        = session::edit_of(session::record_of(own), methods::all_methods().edits).value();
    EXPECT_EQ(again.get<DrawTree>()->search, silhouette::Search::AnyLevel);
    auto const deeper = scene::apply_edit(tree, own).value();
    auto const& drawn = silhouette::outlined_tree(*deeper.drawn)->own_branches;
    ASSERT_EQ(drawn.size(), 2u);
    EXPECT_TRUE(drawn[1].branch.starts_with(parent + "/")) << drawn[1].branch;
    auto const said = OutlineTool::kKind.describe(tools::Tool(alone), deeper);
    EXPECT_EQ(said, "The branch bears 1 branch that you drew");
    OutlineTool const of_trunks { .branches = OutlineTool::Branches::OfNearest };
    EXPECT_EQ(meant(twig, tree, of_trunks).search, silhouette::Search::OnTrunk);
    auto const record = session::record_of(meant(twig, tree, of_trunks));
    EXPECT_EQ(record.fields.find("at_any_level"), std::string::npos);
}

TEST(OutlineTool, SaysWhatWaitsForItsBranch)
{
    auto tree = crowned();
    tree = after(tree, line_from_branch(*silhouette::outlined_tree(*tree.drawn)));
    std::vector<Vec3> narrow;
    for (int i = 0; i <= 60; ++i)
        narrow.emplace_back(7 * std::sin(i * kPi / 30), 10 - 38 * std::cos(i * kPi / 30), 150);
    auto const without = after(tree, stroke_through(narrow));
    ASSERT_EQ(silhouette::outlined_tree(*without.drawn)->own_branches.size(), 1u);
    EXPECT_NE(OutlineTool::kKind.describe(OutlineTool {}, without).find("waits for it"),
              std::string::npos);
    auto const again = after(without, crown_around(0, 10));
    EXPECT_EQ(silhouette::count_without_effect(*silhouette::outlined_tree(*again.drawn)).value(),
              0u);
}

TEST(OutlineTool, RefinesABranchStepByStep)
{
    document::Document document({}, document::Document::Working::AtOnce);
    for (auto const& stroke : { trunk_at(0), crown_around(0, 10) })
        document.draw({ stroke, OutlineTool {} });
    auto const before = document.newest()->scene.base->node_position_mm;
    auto const outlines = [&] {
        return silhouette::outlined_tree(*document.newest()->scene.drawn)->own_outlines.size();
    };
    document.draw({ lobe_of_crown(), OutlineTool {} });
    ASSERT_EQ(outlines(), 1u);
    auto const said = OutlineTool::kKind.describe(OutlineTool {}, document.newest()->scene);
    EXPECT_NE(said.find("The branch has its own outline: "), std::string::npos) << said;
    auto const refined = document.newest()->scene.base->node_position_mm;
    EXPECT_NE(refined, before);
    document.draw({ lobe_of_crown(1.2), OutlineTool {} });
    EXPECT_EQ(outlines(), 1u) << "it takes the other one's place";
    document.undo();
    EXPECT_EQ(document.newest()->scene.base->node_position_mm, refined);
    document.draw({ crown_around(0, 10.5), OutlineTool {} });
    EXPECT_EQ(outlines(), 1u) << "it stays with its branch";
    EXPECT_NE(OutlineTool::kKind.describe(OutlineTool {}, document.newest()->scene)
                  .find("branches on its trunk"),
              std::string::npos);
    document.undo();
    document.draw({ stroke_through({ { 31, 24, 0 }, { 31, 34, 0 } }), EraseOutlineTool {} });
    EXPECT_EQ(outlines(), 0u);
    EXPECT_EQ(document.newest()->scene.base->node_position_mm, before);
    document.undo();
    document.undo();
    EXPECT_EQ(document.newest()->scene.base->node_position_mm, before);
}

TEST(OutlineTool, SaysWhatTheTreeStillWants)
{
    auto const said = [](scene::Scene const& scene) {
        return OutlineTool::kKind.describe(OutlineTool {}, scene);
    };
    auto const stem = after({}, trunk_at(10));
    EXPECT_NE(said(stem).find("draw the outline of its crown"), std::string::npos);
    auto const tree = after(stem, crown_around(10, 10));
    EXPECT_NE(said(tree).find("branches on its trunk"), std::string::npos);
    EXPECT_EQ(said(small_scene()), "");
}

TEST(OutlineTool, BeginsATreeBesideTheOther)
{
    auto const tree = after(after({}, trunk_at(-60)), crown_around(-60, 10));
    EXPECT_EQ(meant(trunk_at(60), tree).plant, 0u);
    EXPECT_EQ(meant(trunk_at(60), tree).stands_at_mm, Vec3(60, 0, 0));
    EXPECT_EQ(meant(crown_around(60, 10), tree).plant, 0u);
    OutlineTool const tool { .what = OutlineTool::What::New };
    EXPECT_EQ(meant(crown_around(-58, 10), tree, tool).plant, 0u);
    auto const both = after(tree, crown_around(60, 10));
    ASSERT_EQ(both.plants.size(), 2u);
    EXPECT_NEAR(both.placement.origin_mm.x(), 60, 2) << "under the middle of its crown";
}

TEST(OutlineTool, RefusesADot)
{
    auto const edit = drawn_tree({}, stroke_through({ { 0, 0, 0 } }), {});
    ASSERT_FALSE(edit);
    EXPECT_NE(edit.error().message.find("a dot"), std::string::npos);
}

TEST(OutlineTool, GivesItsNumbersToTheTreeAtOnce)
{
    document::Document document({}, document::Document::Working::AtOnce);
    document.draw({ trunk_at(0), OutlineTool {} });
    document.draw({ crown_around(0, 10), OutlineTool {} });
    auto const before = document.newest();
    ASSERT_EQ(before->scene.plants.size(), 1u);
    auto const bases = before->scene.base->axes.size();
    document.draw({ {}, OutlineTool { .levels = 1, .what = OutlineTool::What::Form } });
    EXPECT_LT(document.newest()->scene.base->axes.size(), bases);
    document.undo();
    document.draw({ {}, OutlineTool { .what = OutlineTool::What::Reseed } });
    EXPECT_NE(document.newest()->scene.base->node_position_mm,
              before->scene.base->node_position_mm);
    document.undo();
    document.draw({ {}, ArrangeTool {} });
    EXPECT_NE(document.newest()->scene.base->node_position_mm,
              before->scene.base->node_position_mm);
    document.undo();
    EXPECT_EQ(document.newest()->scene.base->node_position_mm,
              before->scene.base->node_position_mm);
    auto const refused = tools::Tool(ArrangeTool {}).edits_for({}, small_scene());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("no outline"), std::string::npos);
}

TEST(ArrangeTool, StandsAsManyBranchesInAWhorlAsItSays)
{
    auto const tools = methods::all_methods().tools;
    EXPECT_EQ(tools::parse_tool(tools, "arrange", "whorls").value(),
              tools::Tool(ArrangeTool { .to = ArrangeTool::To::Whorls, .whorl = 3 }))
        << "as logs have it from before there were others";
    auto const fives = tools::parse_tool(tools, "arrange", "branches whorls whorl=5").value();
    document::Document document({}, document::Document::Working::AtOnce);
    document.draw({ trunk_at(0), OutlineTool {} });
    document.draw({ crown_around(0, 10), OutlineTool {} });
    auto const patterns
        = [&] { return outlined_tree(*document.newest()->scene.drawn)->form.patterns; };
    document.draw({ {}, fives });
    EXPECT_EQ(patterns()[0], Pattern());
    EXPECT_EQ(patterns()[1], Pattern::whorls_of(5));
    EXPECT_EQ(patterns()[2], Pattern::whorls_of(5));
    ArrangeTool next { .around = ArrangeTool::Around::Branches, .whorl = 4 };
    document.draw({ {}, next });
    EXPECT_EQ(patterns()[1], Pattern(Pattern::TwoRows)) << "the one after whorls";
    for (int i = 0; i < 5; ++i)
        document.draw({ {}, next });
    EXPECT_EQ(patterns()[1], Pattern::whorls_of(4));
}

// A log from the time before complete nodes must give its old tree, whatever arrangement a tool
// chooses.
TEST(ArrangeTool, KeepsNodesAsTheyWereWhenTheTreeWasDrawn)
{
    auto const tools = methods::all_methods().tools;
    for (auto const& [words, is_whole] :
         { std::pair("of_any siblings closely", false),
           std::pair("of_any siblings closely whole_nodes", true) }) {
        auto const outline = tools::parse_tool(tools, "outline", words).value();
        document::Document document({}, document::Document::Working::AtOnce);
        document.draw({ trunk_at(0), outline });
        document.draw({ crown_around(0, 10), outline });
        document.draw({ {}, tools::parse_tool(tools, "arrange", "whorls").value() });
        auto const& form = outlined_tree(*document.newest()->scene.drawn)->form;
        EXPECT_EQ(form.has_whole_nodes, is_whole) << words;
        EXPECT_EQ(form.patterns[0], Pattern(Pattern::Whorls));
        // Neither log has this option, which later trees have.
        EXPECT_EQ(form.plane_branches, 0) << words;
    }
}

TEST(OutlineTool, FillsOutlinesBySpacingUnlessALogIsOlder)
{
    auto const tools = methods::all_methods().tools;
    auto const form_by = [&](tools::Tool const& tool) {
        document::Document document({}, document::Document::Working::AtOnce);
        document.draw({ trunk_at(0), tool });
        return outlined_tree(*document.newest()->scene.drawn)->form;
    };
    EXPECT_EQ(form_by(OutlineTool {}).plane_branches, kUsualPlaneBranches);
    EXPECT_EQ(form_by(OutlineTool { .form = OutlineTool::Form::Poplar }).base_angle_deg, 35);
    auto const older
        = form_by(tools::parse_tool(tools, "outline", "poplar closely whole_nodes").value());
    EXPECT_EQ(older.plane_branches, 0);
    EXPECT_EQ(older.base_angle_deg, 0);
}

// Whether leaves fill the outline as seen must be said by the words of the log that drew it.
TEST(OutlineTool, FillsOutlinesWithLeavesUnlessALogIsOlder)
{
    auto const tools = methods::all_methods().tools;
    auto const form_by = [&](std::string const& words) {
        document::Document document({}, document::Document::Working::AtOnce);
        document.draw({ trunk_at(0), tools::parse_tool(tools, "outline", words).value() });
        return outlined_tree(*document.newest()->scene.drawn)->form;
    };
    EXPECT_TRUE(form_by(tools::words_for(OutlineTool {}).arguments).leaves_reach_outline);
    EXPECT_EQ(form_by("fills_to_outline").plane_branches, kUsualPlaneBranches);
    EXPECT_FALSE(form_by("oak closely whole_nodes fills_by_spacing").leaves_reach_outline);
    EXPECT_FALSE(form_by("oak closely whole_nodes").leaves_reach_outline);
}

TEST(OutlineTool, GivesBranchesTheAnglesAndBarkOfTheSpeciesUnlessALogIsOlder)
{
    auto const tools = methods::all_methods().tools;
    auto const form_by = [&](std::string const& words) {
        document::Document document({}, document::Document::Working::AtOnce);
        document.draw({ trunk_at(0), tools::parse_tool(tools, "outline", words).value() });
        return outlined_tree(*document.newest()->scene.drawn)->form;
    };
    for (auto const* const name : { "oak", "pine", "willow", "poplar" }) {
        auto const now = form_by(name + std::string(" fills_by_species"));
        EXPECT_TRUE(now.bases_by_angle) << name;
        EXPECT_NE(now.rise, 0) << name;
        EXPECT_EQ(bark_name(now.bark), name);
        auto const older = form_by(name + std::string(" fills_to_outline"));
        EXPECT_FALSE(older.bases_by_angle) << name;
        EXPECT_EQ(older.rise, 0) << name;
        EXPECT_EQ(older.bark, BarkKind::Furrowed) << name;
        EXPECT_EQ(older.base_angle_deg, name == std::string("poplar") ? 35 : 0) << name;
    }
    EXPECT_FALSE(form_by("fills_by_species").bases_by_angle);
}

// The tool must erase branches before the trunk and the crown's outline. Without its outline, the
// tree is a bare stem. The trunk is then the last line, which cannot be erased.
TEST(EraseOutlineTool, TakesLinesOfTheDrawingAway)
{
    document::Document document({}, document::Document::Working::AtOnce);
    for (auto const& stroke : { trunk_at(0), crown_around(0, 10),
                                stroke_through({ { 1, -10, 0 }, { 12, 0, 0 }, { 26, 4, 0 } }) })
        document.draw({ stroke, OutlineTool {} });
    auto const tree = [&] { return *silhouette::outlined_tree(*document.newest()->scene.drawn); };
    ASSERT_EQ(tree().branches.size(), 1u);
    auto const across = stroke_through({ { 20, -10, 0 }, { 20, 20, 0 } });
    document.draw({ across, EraseOutlineTool {} });
    EXPECT_TRUE(tree().branches.empty());
    EXPECT_FALSE(tree().outline.tips.empty());
    document.draw({ across, EraseOutlineTool {} });
    EXPECT_FALSE(tree().outline.tips.empty()) << "nothing lies there any more";
    document.undo();
    EXPECT_EQ(tree().branches.size(), 1u);
    document.draw(
        { stroke_through({ { 20, 42, 0 }, { 10, 44, 0 }, { -20, 42, 0 } }), EraseOutlineTool {} });
    EXPECT_TRUE(tree().outline.tips.empty());
    EXPECT_EQ(document.newest()->scene.base->axes.size(), 1u);
    document.draw({ across, EraseOutlineTool {} });
    EXPECT_TRUE(tree().branches.empty());
    auto const last
        = tools::Tool(EraseOutlineTool {}).edits_for(trunk_at(0), document.newest()->scene).value();
    auto const refused = scene::apply_edits(document.newest()->scene, last);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("remove the plant"), std::string::npos);
}

TEST(OutlineTool, ShowsBranchesBeforeTheCrownIsClosed)
{
    auto const stem = std::make_shared<scene::Scene const>(after({}, trunk_at(0)));
    tools::Tool const tool = OutlineTool {};
    auto const lines = [&](double share) {
        auto const stroke = crown_around(0, 10, share);
        return outline_previewer()->show({ stem, tool, stroke.tips.vector(), 99 }).size();
    };
    EXPECT_EQ(lines(0.3), 0u);
    EXPECT_GE(lines(0.8), 4u);
    EXPECT_GE(lines(1), 4u);
}

// While a small line is drawn over the crown, the preview must show the branches in the branch's
// own part of the crown as soon as they exist.
TEST(OutlineTool, ShowsBranchesInABranchsOwnOutline)
{
    auto const tree
        = std::make_shared<scene::Scene const>(after(after({}, trunk_at(0)), crown_around(0, 10)));
    tools::Tool const tool = OutlineTool {};
    auto const lines = [&](Stroke const& stroke) {
        return outline_previewer()->show({ tree, tool, stroke.tips.vector(), 99 }).size();
    };
    auto const crown = lines(crown_around(0, 10));
    EXPECT_GE(lines(lobe_of_crown()), crown + 3);
    EXPECT_EQ(lines(lobe_of_crown(0.2)), 0u) << "that may become one";
}

TEST(OutlineLayer, ShowsOutlinesOfBranchesToo)
{
    auto const crown = after(after({}, trunk_at(0)), crown_around(0, 10));
    auto const outlines = kOutlineLayer.lines(after(crown, lobe_of_crown()));
    ASSERT_EQ(outlines.size(), 2u);
    EXPECT_EQ(outlines[1].front(), outlines[1].back()) << "closed";
    for (auto const& point_mm : outlines[1])
        EXPECT_NEAR((Vec2f(point_mm.x() - 19, point_mm.z() - 89)).norm(), 11, 2.5);
}

TEST(OutlineLayer, ShowsTheLinesWhereTheTreeStands)
{
    auto const tree = after(after({}, trunk_at(10)), crown_around(10, 10));
    auto const outline = kOutlineLayer.lines(tree);
    ASSERT_EQ(outline.size(), 1u);
    for (auto const& point_mm : outline[0]) {
        EXPECT_EQ(point_mm.y(), 0);
        EXPECT_NEAR((Vec2f(point_mm.x() - 10, point_mm.z() - 70)).norm(), 33, 4);
    }
    EXPECT_EQ(kTrunkLayer.lines(tree).size(), 1u);
    EXPECT_TRUE(kOutlineLayer.lines(small_scene()).empty());
}

// The layers must show the result of the inference: the chord and the middle of each bump with a
// branch, and each branch's part of the crown.
TEST(OutlineLayer, ShowsWhatWasSeenInTheOutline)
{
    auto const tree = crowned();
    auto const skeleton = silhouette::skeleton_of(*silhouette::outlined_tree(*tree.drawn)).value();
    auto const& system = skeleton.systems[0];
    auto const bumps = std::count_if(system.bumps.begin(), system.bumps.end(), [](auto const& one) {
        return one.role == silhouette::Role::Lateral;
    });
    auto const lines = kSeenLayer.lines(tree);
    ASSERT_EQ(lines.size(), 2 * static_cast<std::size_t>(bumps) + system.branches.size());
    for (auto const& line : lines)
        EXPECT_EQ(line.front(), line.back()) << "closed";
    EXPECT_EQ(kTrianglesLayer.lines(tree).size(), system.outline.size() - 2);
    EXPECT_TRUE(kSeenLayer.lines(after({}, trunk_at(0))).empty());
    EXPECT_TRUE(kTrianglesLayer.lines(small_scene()).empty());
    using Seen = OutlineTool::SeenFor;
    EXPECT_FALSE(kSeenLayer.is_asked_for(OutlineTool {}));
    EXPECT_TRUE(kSeenLayer.is_asked_for(OutlineTool { .seen = Seen::Always }));
    EXPECT_FALSE(kTrianglesLayer.is_asked_for(OutlineTool { .seen = Seen::Always }));
    EXPECT_TRUE(kTrianglesLayer.is_asked_for(OutlineTool { .seen = Seen::WithTriangles }));
    EXPECT_EQ(tools::words_for(OutlineTool { .seen = Seen::Always }).arguments,
              "of_any siblings foot_first seen_stays whole_nodes fills_by_species");
}

} // namespace
} // namespace tractus::silhouette
