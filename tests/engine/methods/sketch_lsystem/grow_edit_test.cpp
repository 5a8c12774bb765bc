#include "engine/methods/sketch_lsystem/grow_edit.h"

#include "engine/methods/sketch_lsystem/stroke_resampler.h"
#include "engine/scene/scene.h"
#include "tests/engine/methods/sketch_lsystem/strokes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus::sketch {
namespace {

Stroke stroke_of(std::vector<Vec3> const& places_mm)
{
    Stroke stroke;
    std::int64_t time_ns = 0;
    for (auto const& place_mm : places_mm)
        stroke.tips.push_back({ .time = timestamp_ns(time_ns += 5'000'000),
                                .position_mm = place_mm,
                                .touching = true });
    return stroke;
}

GrowAlongStroke grown(std::vector<Vec3> const& places_mm)
{
    return { .rule = { .angle_deg = 52, .shortest_mm = 4 },
             .stroke = stroke_of(places_mm),
             .leaves = Leaves::Bare };
}

scene::Scene scene_of(GrowAlongStroke const& edit, scene::Scene const& before = {})
{
    auto scene = scene::apply_edit(before, edit);
    EXPECT_TRUE(scene) << scene.error().message;
    return scene.value_or(scene::Scene {});
}

// `tractus sketch` must write the same model for the same stroke and rule.
TEST(GrowAlongStroke, IsTheModelOfItsStrokeAndRule)
{
    auto const edit = grown(bow());
    auto const axis = draw_axis(edit.rule, resample_stroke(edit.rule, bow()));
    auto const expected = write_model(edit.rule, axis, Leaves::Bare, "sketch");
    EXPECT_EQ(model_of(edit).value().text, expected.text);
}

// The drawn axis must be where the ink is, at any scale of the document's plants.
TEST(GrowAlongStroke, StandsWhereItWasDrawn)
{
    for (double const scale : { 0.1, 0.037, 2.5 }) {
        auto places_mm = bow();
        for (auto& place_mm : places_mm)
            place_mm += Vec3(-40, 25, 60);
        auto edit = grown(places_mm);
        edit.scale = scale;
        auto const scene = scene_of(edit);
        EXPECT_EQ(scene.state.scale, scale);
        auto const nodes_mm = resample_stroke(edit.rule, places_mm);
        auto const& axis = scene.base->axes[0];
        ASSERT_EQ(axis.segment_count + 1, nodes_mm.size());
        for (std::size_t i = 0; i < nodes_mm.size(); ++i) {
            Vec3 const at_mm = scene.placement.world_of_plant(scene.base->positions(axis)[i]);
            EXPECT_NEAR((at_mm - nodes_mm[i]).norm(), 0, 0.01) << "node " << i << " at " << scale;
        }
    }
}

TEST(GrowAlongStroke, StandsUprightWhereItWasDrawnOnPaper)
{
    auto edit = grown({ { 30, -40, 100 }, { 30, 80, 100 } });
    edit.surface = StrokeSurface::Paper;
    auto const scene = scene_of(edit);
    EXPECT_EQ(scene.placement.origin_mm, Vec3(30, 0, 0));
    auto const& axis = scene.base->axes[0];
    Vec3 const top_mm = scene.placement.world_of_plant(scene.base->positions(axis).back());
    EXPECT_NEAR(top_mm.x(), 30, 0.01);
    EXPECT_NEAR(top_mm.y(), 0, 0.01);
    EXPECT_GT(top_mm.z(), 90);
}

TEST(GrowAlongStroke, AddsAPlantThatTakesWhatIsDrawn)
{
    auto const first = scene_of(grown(bow()));
    auto const both = scene_of(grown(straight_stroke(150)), first);
    ASSERT_EQ(both.plants.size(), 2u);
    EXPECT_EQ(both.plants[0], first.plants[0]) << "the first is not grown again";
    EXPECT_EQ(both.state.active, both.plants[1]->drawn->id);
    auto const shaped
        = scene::apply_edits(both,
                             std::vector<scene::Edit> { scene::select_paths(both, { { 0, 1 } }),
                                                        scene::Associate { stroke_of(bow()) } });
    ASSERT_TRUE(shaped) << shaped.error().message;
    EXPECT_EQ(shaped->associations.size(), 1u);
    EXPECT_TRUE(shaped->plants[0]->associations.empty());
}

TEST(GrowAlongStroke, RefusesWhatGrowsNothing)
{
    auto const message = [](GrowAlongStroke const& edit) {
        auto const scene = scene::apply_edit(scene::Scene {}, edit);
        return scene ? std::string() : scene.error().message;
    };
    EXPECT_NE(message(grown(straight_stroke(20))).find("never gets 30 mm away"), std::string::npos);
    EXPECT_NE(message(grown({})).find("never gets 30 mm away"), std::string::npos);
    auto edit = grown(bow());
    edit.rule.laterals = 99;
    EXPECT_NE(message(edit).find("k"), std::string::npos);
    edit = grown(bow());
    edit.scale = std::nan("");
    EXPECT_FALSE(message(edit).empty());
    edit = grown(bow());
    edit.surface = StrokeSurface::Decided;
    EXPECT_FALSE(message(edit).empty());
}

} // namespace
} // namespace tractus::sketch
