#include "app/methods/self_organising/growth_brush_tool.h"

#include "app/methods/self_organising/habit_text.h"
#include "app/tools/stroke_previewer.h"
#include "engine/scene/scene.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

namespace tractus::self_organising {
namespace {

// Returns a stroke that rises and then goes to the side, with a given duration.
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
    auto const edits = tools::Tool(tool).mean(stroke, scene);
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
    EXPECT_EQ(habit_texts().size(), 16U);
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
    // The preview is in the frame of the previously active plant.
    Vec3 const tip_mm
        = after.placement.world_of_plant(after.base->positions(after.base->axes.front()).back());
    Vec3 const shown_mm
        = scene->placement.world_of_plant(lines.front().points_mm.back().cast<double>());
    EXPECT_LT((tip_mm - shown_mm).norm(), 0.05);
}

TEST(GrowthBrushTool, SaysWhatItCannotGrow)
{
    auto const refusal = [](GrowthBrushTool const& tool, scene::Scene const& scene) {
        auto const edits = tools::Tool(tool).mean({}, scene);
        return edits ? std::string() : edits.error().message;
    };
    EXPECT_NE(refusal({}, {}).find("the stroke is empty"), std::string::npos);
    EXPECT_NE(refusal({ .what = GrowthBrushTool::What::Reseed }, {}).find("choose one that has"),
              std::string::npos);
}

} // namespace
} // namespace tractus::self_organising
