#include "app/methods/self_organising/growth_brush_tool.h"

#include "app/methods/fill_crown_tool.h"
#include "app/methods/self_organising/habit_file.h"
#include "app/methods/self_organising/habit_text.h"
#include "app/methods/self_organising/prune_tool.h"
#include "app/tools/stroke_previewer.h"
#include "engine/methods/self_organising/stand.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tractus::self_organising {
namespace {

// Returns a stroke that rises and then goes aside by `aside_mm`, and takes the given time.
Stroke drawn_stroke(Vec3 const& from_mm, double seconds = 5, double aside_mm = 60)
{
    std::vector<TipSample> tips;
    constexpr int kTips = 200;
    for (int i = 0; i <= kTips; ++i) {
        double const share = static_cast<double>(i) / kTips;
        Vec3 const way_mm(aside_mm * share * share, 0, 120 * share);
        tips.push_back({ .time = timestamp_ns(static_cast<std::int64_t>(1e9 * seconds * share)),
                         .position_mm = from_mm + way_mm,
                         .pressure = 0.7,
                         .touching = true });
    }
    return { std::move(tips) };
}

scene::Scene drawn(scene::Scene scene, GrowthBrushTool const& tool, Stroke const& stroke = {})
{
    auto const edits = tools::Tool(tool).edits_for(stroke, scene);
    EXPECT_TRUE(edits) << (edits ? "" : edits.error().message);
    if (!edits)
        return scene;
    auto after = scene::apply_edits(std::move(scene), *edits);
    EXPECT_TRUE(after) << (after ? "" : after.error().message);
    return after ? *std::move(after) : scene::Scene {};
}

int years_of(scene::Scene const& scene)
{
    int years = 0;
    for (auto const& part : grown_tree_of(scene.drawn->source)->life)
        years += part.years;
    return years;
}

TEST(GrowthBrushTool, HasAHabitForEachOfItsWords)
{
    for (int i = 0; i <= static_cast<int>(GrowthBrushTool::Species::Larch); ++i)
        EXPECT_FALSE(habit_of(static_cast<GrowthBrushTool::Species>(i)).latin.empty());
    EXPECT_EQ(habit_of(GrowthBrushTool::Species::Fir).name, "fir");
    EXPECT_EQ(std::ranges::count(habit_texts(), false, &HabitText::is_earlier), 16);
}

// Returns the stroke from its last position to its first.
Stroke from_top(Stroke const& stroke)
{
    std::vector<TipSample> tips(stroke.tips.begin(), stroke.tips.end());
    for (std::size_t i = 0; i < tips.size(); ++i)
        tips[i].position_mm = stroke.tips[tips.size() - 1 - i].position_mm;
    return { std::move(tips) };
}

TEST(GrowthBrushTool, ATreeBegunAtItsTopStandsOnTheGround)
{
    auto const stroke = drawn_stroke(Vec3(30, 0, 0));
    auto const usual = drawn({}, {}, stroke);
    auto const turned = drawn({}, {}, from_top(stroke));
    EXPECT_EQ(turned.state.plants[0]->stands_at_mm, Vec3(30, 0, 0));
    EXPECT_EQ(turned.base->node_position_mm, usual.base->node_position_mm);
    auto const told = [](scene::Scene const& scene, GrowthBrushTool const& tool) {
        return GrowthBrushTool::kKind.describe(tools::Tool(tool), scene);
    };
    EXPECT_NE(told(turned, {}).find("turned round"), std::string::npos);
    EXPECT_EQ(told(usual, {}).find("turned round"), std::string::npos);
    // One touch turns the stroke back, and another one turns it round again.
    GrowthBrushTool const turn { .what = GrowthBrushTool::What::TurnRound };
    auto const back = drawn(turned, turn);
    EXPECT_EQ(back.state.plants[0]->stands_at_mm, Vec3(90, 0, 120));
    EXPECT_EQ(
        back.base->node_position_mm,
        drawn({}, { .base = tools::StrokeBase::AsDrawn }, from_top(stroke)).base->node_position_mm);
    EXPECT_EQ(drawn(back, turn).base->node_position_mm, usual.base->node_position_mm);
    // A stroke that ends high above where other trees stand is a hanging one.
    EXPECT_EQ(drawn(usual, { .what = GrowthBrushTool::What::New },
                    from_top(drawn_stroke(Vec3(200, 0, 90))))
                  .state.plants[1]
                  ->stands_at_mm,
              Vec3(260, 0, 210));
    EXPECT_FALSE(tools::Tool(turn).edits_for({}, {}));
}

TEST(GrowthBrushTool, OlderLogsKeepTheNumbersOfTheirEdition)
{
    using Edition = GrowthBrushTool::Edition;
    std::array const kinds { &GrowthBrushTool::kKind, &methods::FillCrownTool::kKind };
    auto const edition_in = [&](char const* words) {
        return tools::parse_tool(kinds, GrowthBrushTool::kKind.word, words)
            .value()
            .get<GrowthBrushTool>()
            ->edition;
    };
    EXPECT_EQ(edition_in("birch new"), Edition::Pipe);
    EXPECT_EQ(edition_in("birch new rings"), Edition::Rings);
    EXPECT_EQ(edition_in("birch new full"), Edition::Full);
    auto const filled = tools::parse_tool(kinds, methods::FillCrownTool::kKind.word, "oak").value();
    EXPECT_EQ(filled.get<methods::FillCrownTool>()->edition, Edition::Pipe);

    using Species = GrowthBrushTool::Species;
    EXPECT_EQ(habit_of(Species::Birch, Edition::Pipe).ring_mm, 0);
    EXPECT_GT(habit_of(Species::Birch, Edition::Rings).ring_mm, 0);
    EXPECT_EQ(habit_of(Species::Birch, Edition::Rings).shade, 0.12);
    EXPECT_EQ(habit_of(Species::Spruce, Edition::Pipe).shoot_needles, 0);
    EXPECT_GT(habit_of(Species::Spruce, Edition::Full).shoot_needles, 0);
    EXPECT_EQ(habit_of(Species::Spruce), load_habit("spruce").value());
    EXPECT_EQ(habit_of(Species::Alder, Edition::Rings).ring_slenderness, 0);
    auto const stroke = drawn_stroke({ 0, 0, 0 }, 5);
    auto const older = drawn({}, { .edition = Edition::Pipe }, stroke);
    auto const newer = drawn({}, { .edition = Edition::Rings }, stroke);
    EXPECT_EQ(older.base->node_position_mm, newer.base->node_position_mm);
    EXPECT_EQ(older.base->organs.size(), newer.base->organs.size());
    EXPECT_LT(older.base->node_radius_mm.front(), newer.base->node_radius_mm.front());
}

TEST(GrowthBrushTool, GrowsATreeByThePensTime)
{
    auto const quick = drawn({}, {}, drawn_stroke({ 10, 20, 0 }, 2));
    EXPECT_EQ(years_of(quick), 8);
    auto const slow = drawn({}, {}, drawn_stroke({ 10, 20, 0 }, 6));
    EXPECT_EQ(years_of(slow), 24);
    EXPECT_GT(slow.base->segment_count(), quick.base->segment_count());
    EXPECT_EQ(slow.drawn->stands_at_mm, Vec3(10, 20, 0));
}

TEST(GrowthBrushTool, GoesOnWithTheTreeOnWhichTheStrokeBegins)
{
    auto const first = drawn({}, {}, drawn_stroke({ 0, 0, 0 }));
    auto const on_it = drawn(first, {}, drawn_stroke({ 0, 0, 60 }, 4, -80));
    ASSERT_EQ(on_it.plants.size(), 1U);
    EXPECT_EQ(grown_tree_of(on_it.drawn->source)->life.size(), 2U);
    auto const beside = drawn(first, {}, drawn_stroke({ 150, 0, 0 }));
    EXPECT_EQ(beside.plants.size(), 2U);
    EXPECT_NE(grown_tree_of(beside.drawn->source)->seed, grown_tree_of(first.drawn->source)->seed);
    auto const anew
        = drawn(first, { .what = GrowthBrushTool::What::New }, drawn_stroke({ 0, 0, 60 }));
    EXPECT_EQ(anew.plants.size(), 2U);
}

TEST(GrowthBrushTool, GrowsByItselfAtOnce)
{
    auto scene = drawn({}, { .what = GrowthBrushTool::What::TenYears });
    EXPECT_EQ(years_of(scene), 10);
    scene = drawn(scene, { .what = GrowthBrushTool::What::Year });
    EXPECT_EQ(years_of(scene), 11);
    ASSERT_EQ(scene.plants.size(), 1U);
    auto const before = scene.base->node_position_mm;
    auto const other = drawn(scene, { .what = GrowthBrushTool::What::Reseed });
    EXPECT_NE(other.base->node_position_mm, before);
    auto const spruce = drawn(
        scene,
        { .species = GrowthBrushTool::Species::Spruce, .what = GrowthBrushTool::What::Habit });
    EXPECT_EQ(grown_tree_of(spruce.drawn->source)->habit.name, "spruce");
    EXPECT_EQ(years_of(spruce), 11);
}

TEST(GrowthBrushTool, PreviewsTheTreeThatTheStrokeLeaves)
{
    auto const stroke = drawn_stroke({ 0, 0, 0 });
    tools::Tool const tool(GrowthBrushTool {});
    auto const scene
        = std::make_shared<scene::Scene const>(drawn({}, {}, drawn_stroke({ -200, 0, 0 })));
    auto const previewer = growth_brush_previewer();
    std::size_t before = 0;
    auto const& tips = stroke.tips.vector();
    for (std::size_t count = 40; count <= tips.size(); count += 40) {
        auto const lines
            = previewer->show({ .scene = scene, .tool = tool, .ink = { tips.data(), count } });
        EXPECT_GE(lines.size(), before);
        before = lines.size();
    }
    auto const lines = previewer->show({ .scene = scene, .tool = tool, .ink = tips });
    auto const after = drawn(*scene, {}, stroke);
    ASSERT_EQ(lines.size(), after.base->axes.size());
    // The preview's points are in the frame of the plant that was active before the stroke.
    Vec3 const tip_mm
        = after.placement.world_of_plant(after.base->positions(after.base->axes.front()).back());
    Vec3 const shown_mm
        = scene->placement.world_of_plant(lines.front().points_mm.back().cast<double>());
    EXPECT_LT((tip_mm - shown_mm).norm(), 0.05);
}

template<typename T>
scene::Scene drawn_with(scene::Scene scene, T const& tool, Stroke const& stroke = {})
{
    auto const edits = tools::Tool(tool).edits_for(stroke, scene);
    EXPECT_TRUE(edits) << (edits ? "" : edits.error().message);
    if (!edits)
        return scene;
    auto after = scene::apply_edits(std::move(scene), *edits);
    EXPECT_TRUE(after) << (after ? "" : after.error().message);
    return after ? *std::move(after) : scene::Scene {};
}

template<typename T>
std::string refusal_of(T const& tool, scene::Scene const& scene, Stroke const& stroke = {})
{
    auto const edits = tools::Tool(tool).edits_for(stroke, scene);
    return edits ? std::string() : edits.error().message;
}

scene::Scene model_plant()
{
    return scene::apply_edit(
               {},
               scene::LoadModel { .source = { .text = "#define STEPS 1\n"
                                                      "Lsystem: 1\nderivation length: 1\n"
                                                      "Axiom: !(60)F(700)[+(50)F(600)]F(700)"
                                                      "[-(50)F(500)]F(600)\n"
                                                      "endlsystem\n" } })
        .value();
}

TEST(GrowthBrushTool, GrowsFromAnyPlantAsItStands)
{
    auto const before = model_plant();
    auto const year = drawn(before, { .what = GrowthBrushTool::What::FromYear });
    ASSERT_EQ(year.plants.size(), 1U);
    EXPECT_EQ(years_of(year), 1);
    EXPECT_GT(year.base->segment_count(), before.base->segment_count());
    Vec3 const tip_mm
        = before.placement.world_of_plant(before.base->positions(before.base->axes[0]).back());
    auto const brushed
        = drawn(before, { .what = GrowthBrushTool::What::From }, drawn_stroke(tip_mm, 3));
    ASSERT_EQ(brushed.plants.size(), 1U);
    EXPECT_EQ(years_of(brushed), 12);
    EXPECT_GT(bounds(*brushed.base).max_mm.z(), bounds(*before.base).max_mm.z());
    // A plant that the growth brush has made continues with its own history of growth.
    auto const again = drawn(year, { .what = GrowthBrushTool::What::FromYear });
    EXPECT_EQ(grown_tree_of(again.drawn->source)->life.size(), 2U);
    EXPECT_NE(refusal_of(GrowthBrushTool { .what = GrowthBrushTool::What::From }, {},
                         drawn_stroke({ 0, 0, 0 }))
                  .find("draw or open one"),
              std::string::npos);
}

TEST(GrowthBrushTool, PreviewsGrowthFromAnyPlant)
{
    auto const scene = std::make_shared<scene::Scene const>(model_plant());
    Vec3 const tip_mm
        = scene->placement.world_of_plant(scene->base->positions(scene->base->axes[0]).back());
    auto const stroke = drawn_stroke(tip_mm, 2);
    GrowthBrushTool const options { .what = GrowthBrushTool::What::From };
    tools::Tool const tool(options);
    auto const lines = growth_brush_previewer()->show(
        { .scene = scene, .tool = tool, .ink = stroke.tips.vector() });
    EXPECT_EQ(lines.size(), drawn(*scene, options, stroke).base->axes.size());
}

TEST(GrowthBrushTool, GrowsAllTreesBesideEachOther)
{
    auto scene = drawn({}, { .what = GrowthBrushTool::What::New }, drawn_stroke({ 0, 0, 0 }, 1));
    scene = drawn(scene, { .what = GrowthBrushTool::What::New }, drawn_stroke({ 60, 0, 0 }, 1));
    auto const later = drawn(scene, { .what = GrowthBrushTool::What::AllTenYears });
    ASSERT_EQ(later.plants.size(), 2U);
    for (auto const& plant : later.plants) {
        auto const* const tree = grown_tree_of(plant->drawn->source);
        ASSERT_TRUE(tree);
        EXPECT_EQ(tree->life.back().years, 10);
        EXPECT_EQ(tree->life.back().stand->place().members.size(), 2U);
    }
}

TEST(PruneTool, CutsTheActiveTree)
{
    auto const tree = drawn({}, { .what = GrowthBrushTool::What::TenYears });
    auto const top = bounds(*tree.base).max_mm;
    Vec3 const at_mm = tree.placement.world_of_plant({ 0, 0, 0.6 * top.z() });
    auto const across = drawn_stroke(at_mm - Vec3(60, 0, 0), 1, 120);
    auto const pruned
        = drawn_with(tree, PruneTool { .min_radius_mm = 10, .most_radius_mm = 40 }, across);
    EXPECT_LT(pruned.base->segment_count(), tree.base->segment_count());
    auto const grown = drawn(pruned, { .what = GrowthBrushTool::What::Year });
    EXPECT_GT(grown.base->segment_count(), pruned.base->segment_count());
    EXPECT_NE(
        refusal_of(PruneTool {}, tree, drawn_stroke({ 900, 900, 0 })).find("touched no branch"),
        std::string::npos);
    EXPECT_NE(refusal_of(PruneTool {}, model_plant(), across).find("From any plant"),
              std::string::npos);
    EXPECT_NE(refusal_of(PruneTool { .what = PruneTool::What::Clear }, tree, across)
                  .find("no brush has swept"),
              std::string::npos);
}

TEST(PruneTool, ClearsSpaceOfTheBrush)
{
    auto const tree = drawn({}, {}, drawn_stroke({ 0, 0, 0 }, 5, 0));
    auto const cleared = drawn_with(
        tree,
        PruneTool { .what = PruneTool::What::Clear, .min_radius_mm = 40, .most_radius_mm = 40 },
        drawn_stroke({ 0, 0, 70 }, 1, 0));
    EXPECT_LT(bounds(*cleared.base).max_mm.z(), 0.9 * bounds(*tree.base).max_mm.z());
    auto const other = drawn(
        cleared,
        { .species = GrowthBrushTool::Species::Birch, .what = GrowthBrushTool::What::Habit });
    EXPECT_LT(bounds(*other.base).max_mm.z(), 0.9 * bounds(*tree.base).max_mm.z());
}

TEST(PruneTool, IsWhatTheOtherEndOfThePenDoes)
{
    EXPECT_EQ(GrowthBrushTool::kKind.other_end.kind, &PruneTool::kKind);
}

// Returns a tree drawn by its trunk, a round outline and one branch.
scene::Scene outlined_tree()
{
    auto const flat = [](std::vector<Vec2> const& points) {
        std::vector<TipSample> tips;
        for (auto const& point : points)
            tips.push_back({ .position_mm = Vec3(point.x(), point.y(), 140), .touching = true });
        return Stroke { std::move(tips) };
    };
    std::vector<Vec2> circle;
    for (int i = 0; i <= 120; ++i) {
        double const angle = -kPi / 2 + 2 * kPi * i / 120;
        circle.emplace_back(40 * std::cos(angle), 40 * std::sin(angle));
    }
    using silhouette::DrawTree;
    auto scene = scene::apply_edit(
                     {},
                     DrawTree { .part = DrawTree::Part::Trunk,
                                .stroke = flat({ { 0, -80 }, { 0, -40 }, { 0, 0 }, { 0, 20 } }),
                                .scale = 0.02 })
                     .value();
    auto const id = scene.state.active;
    scene = scene::apply_edit(scene, DrawTree { .stroke = flat(circle), .plant = id }).value();
    return scene::apply_edit(
               scene,
               DrawTree { .part = DrawTree::Part::Branch,
                          .stroke = flat({ { 0, -20 }, { 10, -10 }, { 20, 0 }, { 30, 5 } }),
                          .plant = id })
        .value();
}

TEST(FillCrownTool, FillsAnOutlinedCrown)
{
    auto const before = outlined_tree();
    auto const after = drawn_with(before, methods::FillCrownTool {});
    ASSERT_EQ(after.plants.size(), 1U);
    auto const* const tree = grown_tree_of(after.drawn->source);
    ASSERT_TRUE(tree);
    EXPECT_EQ(tree->start->kept_axes.size(), 2U) << "the trunk and the branch that was drawn";
    // In the plant's frame, the crown is a ball with a radius of 2000 mm at a height of 4000 mm.
    Vec3 const middle(0, 0, 4000);
    std::array<int, 8> in_octant {};
    int outside = 0;
    for (auto const& node : after.base->node_position_mm) {
        if (node.z() < 2000)
            continue; // The node is on the trunk below the crown.
        Vec3 const at = node - middle;
        outside += at.norm() > 2000 * 1.12 ? 1 : 0;
        if (at.norm() > 1000)
            ++in_octant[(at.x() > 0 ? 1U : 0U) + (at.y() > 0 ? 2U : 0U) + (at.z() > 0 ? 4U : 0U)];
    }
    EXPECT_EQ(outside, 0);
    for (auto const count : in_octant)
        EXPECT_GT(count, 100) << "all of the crown is filled";
    for (auto const& node : after.base->node_position_mm)
        if (node.z() < 1900)
            EXPECT_LT(node.head<2>().norm(), 300) << "nothing grows below the crown";
}

TEST(FillCrownTool, NeedsAnOutline)
{
    EXPECT_NE(refusal_of(methods::FillCrownTool {}, model_plant()).find("drawn by its outline"),
              std::string::npos);
    EXPECT_NE(refusal_of(methods::FillCrownTool {}, {}), "");
}

TEST(GrowthBrushTool, SaysWhatItCannotGrow)
{
    auto const refusal = [](GrowthBrushTool const& tool, scene::Scene const& scene) {
        auto const edits = tools::Tool(tool).edits_for({}, scene);
        return edits ? std::string() : edits.error().message;
    };
    EXPECT_NE(refusal({}, {}).find("the stroke is empty"), std::string::npos);
    EXPECT_NE(refusal({ .what = GrowthBrushTool::What::Reseed }, {}).find("choose one that has"),
              std::string::npos);
}

} // namespace
} // namespace tractus::self_organising
