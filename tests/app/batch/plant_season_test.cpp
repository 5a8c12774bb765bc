#include "app/batch/plant_season.h"

#include "app/batch/plant_group.h"
#include "app/batch/session_plant.h"
#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/methods/all_methods.h"
#include "engine/export/glb_writer.h"
#include "engine/mesh/make_mesh.h"
#include "tests/app/our_plant.h"
#include "tests/app/small_model.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <set>
#include <sstream>
#include <unistd.h>

namespace tractus::batch {
namespace {

std::string glb_of(Plant const& plant)
{
    auto const mesh = mesh::make_mesh(plant);
    exports::PlacedMesh placed;
    placed.mesh = &mesh;
    std::ostringstream out;
    EXPECT_TRUE(exports::write_glb(out, std::span(&placed, 1)));
    return out.str();
}

// Returns the materials of a plant's leaves.
std::set<MaterialId> leaf_materials(Plant const& plant)
{
    std::set<MaterialId> materials;
    for (auto const& organ : plant.organs)
        materials.insert(plant.organ_shapes[organ.shape].material);
    return materials;
}

TEST(PlantSeason, GrowsLeavesOfTheSeasonOnOnePage)
{
    auto const summer = our_plant("birch");
    auto const edits = season_edits(summer, scene::Season { .month = 10.2, .fallen = 1 }).value();
    ASSERT_EQ(edits.size(), 2u);
    ASSERT_NE(edits[0].get<scene::KeepLeaves>(), nullptr);
    auto const autumn = scene::apply_edits(summer, edits).value();
    auto const& plant = *autumn.in_season;
    check_plant(plant);
    EXPECT_EQ(plant.organs.size(), summer.base->organs.size()) << "they are all somewhere";
    EXPECT_EQ(leaf_materials(plant).size(), 1u);
    EXPECT_LT(mesh::make_mesh(plant).triangle_count(),
              mesh::make_mesh(*summer.base).triangle_count() * 3 / 2);
    auto const leaves = plant.materials[*leaf_materials(plant).begin()].base_color;
    auto const green = summer.base->materials[*leaf_materials(*summer.base).begin()].base_color;
    EXPECT_GT(green.y(), green.x());
    EXPECT_GT(leaves.x(), leaves.y()) << "yellow";
    // Only the season changes: the leaves exist already and must not be grown again.
    EXPECT_EQ(season_edits(autumn, scene::Season { .month = 10.2, .fallen = 0 }).value().size(),
              1u);
}

TEST(PlantSeason, IsKeptByASession)
{
    auto const path = std::filesystem::temp_directory_path()
        / ("tractus_season_test_" + std::to_string(::getpid()) + ".tractus");
    std::filesystem::remove(path);
    std::vector<scene::Edit> edits {
        io::load_model_edit(files::find_model("birch").value()).value()
    };
    auto scene = scene::apply_edits({}, edits).value();
    auto const season = season_edits(scene, scene::Season { .month = 4.8 }).value();
    edits.insert(edits.end(), season.begin(), season.end());
    scene = scene::apply_edits({}, edits).value();
    ASSERT_TRUE(begin_session(path, edits, methods::all_methods().edits));
    auto const opened = load_session_scene(path, methods::all_methods().edits);
    std::filesystem::remove(path);
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_EQ(opened->state.season, scene.state.season);
    EXPECT_TRUE(glb_of(shown_plants(*opened).value()) == glb_of(shown_plants(scene).value()));
}

TEST(PlantSeason, SaysWhichLeavesCannotBeGrown)
{
    auto scene = small_scene();
    auto plant = *scene.base;
    auto cut = std::make_shared<CutLeaf>();
    cut->sheet = "no-such-leaf 4 0.5.leaf-sheet";
    cut->corners = { { 0, 0 }, { 1, 0 }, { 0, 1 } };
    plant.materials.push_back({ .kind = Material::Kind::Leaf });
    plant.organ_shapes.push_back({ .kind = OrganShape::Kind::Leaf,
                                   .material = static_cast<MaterialId>(plant.materials.size() - 1),
                                   .cut = cut });
    auto built = std::make_shared<scene::BuiltPlant>(*scene.plants[0]);
    built->base = built->foliated = std::make_shared<Plant const>(plant);
    scene.plants[0] = built;
    auto const edits = season_edits(scene, scene::Season {});
    ASSERT_FALSE(edits);
    EXPECT_TRUE(edits.error().message.starts_with(
        "the plants cannot change with the season: there is no leaf no-such-leaf"))
        << edits.error().message;
}

TEST(PlantGroup, IsThePlantsOfADocumentWhereTheyStand)
{
    auto scene = small_scene();
    auto const one = shown_plants(scene).value();
    scene::CopyPlant const copy { scene.state.active, { 100, 0, 0 } };
    scene = scene::apply_edit(std::move(scene), copy).value();
    auto group = PlantGroup::create(scene).value();
    auto const both = group.plant_as_displayed();
    ASSERT_EQ(both.segment_count(), 2 * one.segment_count());
    double const moved_mm = 100 / scene.placement.scale;
    auto const nodes = one.node_position_mm.size();
    for (std::size_t i = 0; i < nodes; ++i)
        EXPECT_NEAR((both.node_position_mm[nodes + i] - both.node_position_mm[i]).norm(), moved_mm,
                    1e-6);
    variation::PlantKey const key { 7, 3 };
    auto const varied = group.grow(key, 1);
    EXPECT_EQ(varied.segment_count(), both.segment_count());
    EXPECT_NE(varied.node_position_mm, both.node_position_mm);
    EXPECT_EQ(group.grow(key, 1).node_position_mm, varied.node_position_mm);
    check_plant(varied);
    EXPECT_LT(bounds(group.grow(key, 0.3)).max_mm.z(), bounds(varied).max_mm.z());
    auto const shown = scene.plants;
    for (auto const& plant : shown)
        scene = scene::apply_edit(std::move(scene), scene::HidePlant { plant->drawn->id }).value();
    EXPECT_FALSE(PlantGroup::create(scene));
}

} // namespace
} // namespace tractus::batch
