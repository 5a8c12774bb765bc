#include "engine/scene/scene_shaper.h"
#include "engine/variation/individual.h"
#include "engine/variation/place_nodes.h"
#include "tests/engine/scene/limbs.h"

namespace tractus::scene {
namespace {

std::vector<Vec3> bent_nodes(Scene const& scene)
{
    SceneShaper shaper;
    EXPECT_TRUE(shaper.set_plant(scene));
    std::vector<Vec3> nodes_mm;
    variation::place_nodes(*scene.base, *scene.rest, shaper.shape(), nodes_mm);
    return nodes_mm;
}

TEST(LimbStrokes, AreSelectedAndShapedAsOtherBranches)
{
    auto scene = tree_scene();
    scene = after({ on_segment(scene, 2, winding({ 0, 0, 300 }, 300)) }, scene);
    auto const limb = limb_axis(scene);
    auto const before_mm = bent_nodes(scene);
    scene = after(
        { select_paths(scene, { segments_of(limb) }), shaping(variation::Propagation::Selected) },
        scene);
    ASSERT_EQ(scene.associations.size(), 1u);
    EXPECT_EQ(scene.associations[0].what.path.vector(), segments_of(limb));
    auto const after_mm = bent_nodes(scene);
    EXPECT_EQ(before_mm[limb.first_node], after_mm[limb.first_node]);
    EXPECT_GT((before_mm[limb.first_node + limb.segment_count]
               - after_mm[limb.first_node + limb.segment_count])
                  .norm(),
              50);
    EXPECT_EQ(before_mm[1], after_mm[1]) << "the trunk stays";
}

TEST(LimbStrokes, TakeWhatIsPropagatedAfterThemAndNotBefore)
{
    auto scene = tree_scene();
    scene = after({ select_paths(scene, { segments_of(scene.base->axes[0]) }),
                    shaping(variation::Propagation::Descendants) },
                  scene);
    auto const places_mm = winding({ 0, 0, 300 }, 300);
    scene = after({ on_segment(scene, 2, places_mm) }, scene);
    auto const limb = limb_axis(scene);
    auto const as_drawn_mm = bent_nodes(scene);
    for (std::uint32_t i = 0; i <= limb.segment_count; ++i)
        EXPECT_LT(distance_to(places_mm, as_drawn_mm[limb.first_node + i]), 1e-6);
    auto const copy = after({ CopyPlant { scene.state.active, { 900, 0, 0 } } }, scene);
    EXPECT_EQ(bent_nodes(copy), as_drawn_mm) << "a copy's limb, too";
    auto const later = after({ shaping(variation::Propagation::Descendants) }, scene);
    auto const later_mm = bent_nodes(later);
    auto const chord_of = [&](std::vector<Vec3> const& nodes_mm, Axis const& axis) {
        return Vec3(nodes_mm[axis.first_node + axis.segment_count] - nodes_mm[axis.first_node])
            .normalized();
    };
    EXPECT_LT(chord_of(later_mm, limb).z(), chord_of(as_drawn_mm, limb).z() - 0.2)
        << "it hangs as the stroke does";
}

TEST(LimbStrokes, FollowWhatBearsThem)
{
    auto scene = tree_scene();
    scene = after({ on_segment(scene, 2, winding({ 0, 0, 300 }, 300)) }, scene);
    auto const limb = limb_axis(scene);
    scene = after({ select_paths(scene, { segments_of(scene.base->axes[0]) }),
                    Associate { .stroke = stroke_towards({ 80, 0, 0 }),
                                .fit = variation::StrokeFit::World } },
                  scene);
    auto const nodes_mm = bent_nodes(scene);
    EXPECT_GT(nodes_mm[3].x(), 50) << "the trunk leans";
    EXPECT_LT((nodes_mm[limb.first_node] - nodes_mm[3]).norm(), 1e-9);
    // A limb drawn on the leaning trunk must stand where it was drawn.
    variation::RestShape const& rest = *scene.rest;
    SceneShaper shaper;
    ASSERT_TRUE(shaper.set_plant(scene));
    Eigen::AngleAxisd const turn(rest.frame[3] * shaper.shape().frame[3].conjugate());
    auto const places_mm = winding(nodes_mm[4], 250);
    auto edit = on_segment(scene, 3, places_mm);
    edit.joint_mm = nodes_mm[4];
    edit.turn_rad = turn.angle() * turn.axis();
    auto const both = after({ edit }, scene);
    auto const& second = limb_axis(both, 1);
    auto const drawn_mm = bent_nodes(both);
    for (std::uint32_t i = 0; i <= second.segment_count; ++i)
        EXPECT_LT(distance_to(places_mm, drawn_mm[second.first_node + i]), 1e-6);
}

TEST(LimbStrokes, AreInEveryPlantOfACollection)
{
    auto scene = tree_scene();
    // The limb grows on a twig, so the parent of this twig must stay, too.
    auto const twig = scene.base->axes[3].first_segment + 1;
    scene = after({ on_segment(scene, twig, winding({ 0, 0, 500 }, 300)) }, scene);
    auto const kept = variation::axes_below_paths(*scene.base, drawn_paths(scene));
    Vec3 const tip_mm = scene.base->positions(limb_axis(scene)).back();
    for (std::uint32_t index = 0; index < 40; ++index) {
        auto const other
            = variation::individual(*scene.base, { 3, index }, { .branches = 0.5 }, kept);
        EXPECT_NE(std::find(other.node_position_mm.begin(), other.node_position_mm.end(), tip_mm),
                  other.node_position_mm.end())
            << index;
    }
}

} // namespace
} // namespace tractus::scene
