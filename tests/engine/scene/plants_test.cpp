#include "engine/scene/scene_builder.h"

#include "engine/plant/join_axes.h"
#include "engine/variation/growth.h"
#include "tests/engine/scene/edits.h"

namespace tractus::scene {
namespace {

// Returns a model of a trunk with the given number of internodes and one branch.
LoadModel model(int internodes, Drawn drawn = Drawn::Beside,
                Vec3 const& stands_at_mm = Vec3::Zero())
{
    std::string text = "Lsystem: 1\nderivation length: 1\nAxiom: F(10)[+(60)F(8)]";
    for (int i = 1; i < internodes; ++i)
        text += "F(10)";
    return { .source = { .name = std::to_string(internodes) + ".l",
                         .text = text + "\nA --> A\nendlsystem\n" },
             .drawn = drawn,
             .stands_at_mm = stands_at_mm };
}

Select trunk_of(Scene const& scene)
{
    return select_paths(scene, { segments_of(scene.base->axes[0]) });
}

std::vector<ItemId> plants_of(Scene const& scene)
{
    std::vector<ItemId> ids;
    for (auto const& plant : scene.plants)
        ids.push_back(plant->drawn->id);
    return ids;
}

TEST(Plants, ADocumentBeginsWithNone)
{
    Scene const scene;
    EXPECT_TRUE(scene.plants.empty());
    EXPECT_EQ(scene.base->segment_count(), 0u);
    auto const first = after({ model(3) });
    EXPECT_EQ(plants_of(first), (std::vector { item_id(1, 0) }));
    auto const none = after({ RemovePlant { item_id(1, 0) } }, first);
    EXPECT_TRUE(none.plants.empty());
    EXPECT_EQ(none.state.active, 0u);
    EXPECT_EQ(none.base->segment_count(), 0u);
}

TEST(Plants, TakeWhatIsDrawnOneAtATime)
{
    auto scene = after({ model(3), model(5, Drawn::Beside, { 100, 0, 0 }) });
    auto const plants = plants_of(scene);
    ASSERT_EQ(plants.size(), 2u);
    EXPECT_EQ(scene.base->segment_count(), 6u) << "the newest is active";
    scene = after({ trunk_of(scene), Associate { stroke_towards({ 40, 0, 0 }) } }, scene);
    EXPECT_EQ(scene.associations.size(), 1u);
    auto const first = after({ ActivatePlant { plants[0] } }, scene);
    EXPECT_EQ(first.base->segment_count(), 4u);
    EXPECT_TRUE(first.associations.empty());
    EXPECT_TRUE(first.selection.empty());
    auto const second = after({ ActivatePlant { plants[1] } }, first);
    EXPECT_EQ(second.associations.size(), 1u);
    EXPECT_EQ(second.selection.size(), 1u);
    EXPECT_FALSE(apply_edit(scene, ActivatePlant { item_id(9, 0) }));
}

// The id of a stroke must identify it, whichever plant is active.
TEST(Plants, KeepTheirStrokesApart)
{
    auto scene = after({ model(3) });
    scene = after({ trunk_of(scene), Associate { stroke_towards({ 40, 0, 0 }) }, model(5) }, scene);
    auto const stroke = item_id(3, 0);
    EXPECT_TRUE(scene.associations.empty());
    auto const smoothed = after({ SmoothStroke { { { stroke } }, 0.5 } }, scene);
    EXPECT_EQ(smoothed.plants[0]->associations[0].what.detail_weight, 0.5);
    EXPECT_EQ(smoothed.plants[1], scene.plants[1]) << "nothing is done again for the other";
}

TEST(Plants, AreShownInOneSize)
{
    auto const alone = after({ model(3) });
    auto const both = after({ model(30, Drawn::Beside, { 100, 20, 0 }) }, alone);
    EXPECT_EQ(both.placement.scale, alone.placement.scale);
    EXPECT_NE(both.fitted.scale, both.placement.scale);
    EXPECT_EQ(both.placement.world_of_plant(Vec3::Zero()), Vec3(100, 20, 0));
    EXPECT_NEAR(both.placement.shown_height_mm, 3000 * both.placement.scale, 1e-9);
    auto const smaller = after({ SetScale { 0.1 } }, both);
    for (auto const& plant : smaller.plants)
        EXPECT_EQ(plant->placement.scale, 0.1);
    EXPECT_FALSE(apply_edit(both, SetScale { 0 }));
    EXPECT_FALSE(apply_edit(both, SetScale { std::nan("") }));
}

// A plant at another position must be the same plant. A motion indicator beside it must have the
// same effect.
TEST(Plants, GrowAlikeWhereverTheyStand)
{
    Vec3 const there_mm(80, -30, 0);
    auto const indicator = [](Vec3 const& moved_mm) {
        return Indicate { { .start_mm = moved_mm,
                            .end_mm = Vec3(60, 0, 90) + moved_mm,
                            .kind = variation::MotionIndicator::Kind::Light } };
    };
    auto const grown = [](Scene const& scene) {
        auto const plan = plan_growth(scene).value();
        return variation::Grower(plan).grow({}).node_position_mm;
    };
    auto const here = after({ model(6), indicator(Vec3::Zero()) });
    auto const there = after({ model(6, Drawn::Beside, there_mm), indicator(there_mm) });
    auto const one = grown(here);
    auto const other = grown(there);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i)
        EXPECT_NEAR((one[i] - other[i]).norm(), 0, 1e-9);
    auto const moved = after({ MovePlant { item_id(1, 0), there_mm } }, here);
    EXPECT_EQ(moved.placement.origin_mm, there_mm);
    EXPECT_EQ(moved.base, here.base);
    EXPECT_NE(grown(moved), one) << "the lamp stays where it is";
}

TEST(Plants, AreCopiedWithAllThatWasDrawn)
{
    auto scene = after({ model(5) });
    scene = after({ trunk_of(scene), Associate { stroke_towards({ 40, 0, 0 }) },
                    Indicate { { .end_mm = { 0, 50, 0 } } }, SetGrowth { {}, 7 } },
                  scene);
    auto const copied = after({ CopyPlant { item_id(1, 0), { 90, 0, 0 } } }, scene);
    ASSERT_EQ(copied.plants.size(), 2u);
    EXPECT_EQ(copied.state.active, item_id(6, 0));
    EXPECT_EQ(copied.base, scene.base) << "it is not derived again";
    EXPECT_EQ(copied.growth.seed, 7u);
    ASSERT_EQ(copied.associations.size(), 1u);
    EXPECT_EQ(copied.associations[0].id, item_id(6, 1));
    EXPECT_EQ(copied.indicators[0].id, item_id(6, 2));
    auto const changed = after({ DeleteStroke { { { item_id(6, 1) } } } }, copied);
    EXPECT_TRUE(changed.associations.empty());
    EXPECT_EQ(changed.plants[0]->associations.size(), 1u) << "the original stays as it is";
}

TEST(Plants, AreHiddenNamedAndTakenAway)
{
    auto const scene = after({ model(3), model(4), model(5) });
    auto const plants = plants_of(scene);
    auto const hidden = after({ HidePlant { plants[1] } }, scene);
    EXPECT_TRUE(hidden.plants[1]->drawn->is_hidden);
    EXPECT_FALSE(after({ HidePlant { plants[1], false } }, hidden).plants[1]->drawn->is_hidden);
    EXPECT_EQ(after({ NamePlant { plants[0], "oak" } }, scene).plants[0]->model_name, "oak");
    EXPECT_FALSE(apply_edit(scene, NamePlant { plants[0], "" }));
    auto const fewer = after({ RemovePlant { plants[2] } }, scene);
    EXPECT_EQ(plants_of(fewer), (std::vector { plants[0], plants[1] }));
    EXPECT_EQ(fewer.state.active, plants[1]);
    EXPECT_EQ(after({ RemovePlant { plants[0] } }, scene).state.active, plants[2]);
    EXPECT_EQ(apply_edit(fewer, MovePlant { plants[2] }).error().message,
              "there is no plant 3 any more");
}

TEST(Plants, AnotherModelTakesThePlaceOfTheActiveOneAlone)
{
    auto const scene = after({ model(3), model(4), model(6, Drawn::Forget) });
    ASSERT_EQ(scene.plants.size(), 2u);
    EXPECT_EQ(scene.plants[0]->base->segment_count(), 4u);
    EXPECT_EQ(scene.plants[1]->base->segment_count(), 7u);
}

// A builder that builds successive states must give the same results as a new builder for each
// state.
TEST(SceneBuilder, BuildsWhatHasChangedAndNothingElse)
{
    SceneBuilder builder;
    DocumentState state;
    auto const apply = [&](Edit const& edit) {
        state = apply_edit(state, edit, builder).value();
        return builder.build(state).value();
    };
    apply(model(3));
    auto const two = apply(model(5));
    auto const selected = apply(trunk_of(two));
    EXPECT_EQ(selected.plants[0], two.plants[0]);
    EXPECT_EQ(selected.base, two.base);
    auto const drawn = apply(Associate { stroke_towards({ 40, 0, 0 }) });
    auto const again = apply(Associate { stroke_towards({ 0, 40, 0 }) });
    EXPECT_EQ(again.associations[0].what.path.data(), again.associations[1].what.path.data())
        << "a branch that is drawn again is looked up once";
    EXPECT_EQ(again.associations[0].what.path.vector(), segments_of(two.base->axes[0]));
    // Returns to an earlier state, and then continues with an equal source. Nothing must be derived
    // again.
    EXPECT_EQ(builder.build(drawn.state).value().base, two.base);
    auto const keeping = apply(model(5, Drawn::Keep));
    EXPECT_NE(keeping.base, two.base) << "its edit is another one";
    EXPECT_EQ(keeping.associations[1].what.path, again.associations[1].what.path);
}

TEST(SceneBuilder, SaysWhichEditBroughtAPlantThatCannotBeBuilt)
{
    SceneBuilder builder;
    DocumentState state;
    for (auto const& edit :
         std::vector<Edit> { model(3),
                             LoadModel { .source = { .name = "broken.l", .text = "Axiom F" },
                                         .drawn = Drawn::Beside } })
        state = apply_edit(std::move(state), edit, builder).value();
    auto const scene = builder.build(state);
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().message.find("broken.l:"), 0u) << scene.error().message;
    EXPECT_EQ(builder.failed_edit(), 2u);
}

} // namespace
} // namespace tractus::scene
