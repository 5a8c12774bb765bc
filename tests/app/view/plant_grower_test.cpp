#include "app/view/plant_grower.h"

#include "engine/mesh/make_mesh.h"
#include "engine/variation/growth.h"
#include "tests/app/small_model.h"

#include <gtest/gtest.h>

namespace tractus::view {
namespace {

std::shared_ptr<scene::Scene const> shared_scene()
{
    return std::make_shared<scene::Scene const>(small_scene());
}

bool same_vertices(mesh::Mesh const& one, mesh::Mesh const& other)
{
    if (one.surfaces.size() != other.surfaces.size())
        return false;
    for (std::size_t i = 0; i < one.surfaces.size(); ++i)
        if (one.surfaces[i].positions_mm != other.surfaces[i].positions_mm)
            return false;
    return true;
}

mesh::Mesh mesh_of(scene::Scene const& scene, std::uint64_t seed)
{
    auto const plan = scene::plan_growth(scene).value();
    return mesh::make_mesh(variation::Grower(plan).grow({ seed, 0 }));
}

TEST(PlantGrower, GrowsThePlantThatTheSceneSays)
{
    PlantGrower grower;
    EXPECT_FALSE(grower.is_growing());
    EXPECT_FALSE(grower.take());
    auto const scene = shared_scene();
    grower.grow({ scene, { {}, 3 } });
    EXPECT_TRUE(grower.is_growing());
    grower.settle();
    EXPECT_TRUE(grower.is_growing()) << "it was not taken";
    auto const plant = grower.take();
    ASSERT_TRUE(plant && *plant);
    EXPECT_TRUE(same_vertices(**plant, mesh_of(*scene, 3)));
    EXPECT_FALSE(grower.is_growing());
    EXPECT_FALSE(grower.take());
}

TEST(PlantGrower, GivesTheNewestOfManyWishes)
{
    PlantGrower grower;
    auto const scene = shared_scene();
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
        grower.grow({ scene, { {}, seed } });
    grower.settle();
    EXPECT_TRUE(same_vertices(*grower.take().value(), mesh_of(*scene, 200)));
    EXPECT_FALSE(grower.is_growing());
}

std::vector<std::uint64_t> seeds(std::vector<Variation> const& variations)
{
    std::vector<std::uint64_t> seeds;
    for (auto const& variation : variations)
        seeds.push_back(variation.seed);
    return seeds;
}

TEST(PlantGrower, GrowsVariationsOfTheNewestWish)
{
    PlantGrower grower;
    auto const scene = shared_scene();
    grower.vary({ { scene, { {}, 100 } }, 50 });
    grower.vary({ { scene, { {}, 7 } }, 3 });
    grower.settle();
    auto const variations = grower.take_variations().value();
    EXPECT_EQ(seeds(variations), (std::vector<std::uint64_t> { 7, 8, 9 }));
    EXPECT_FALSE(same_vertices(variations[0].mesh, variations[1].mesh));
    EXPECT_TRUE(grower.take_variations().value().empty());
    EXPECT_FALSE(grower.is_growing()) << "nobody wants the plant anew";
}

TEST(PlantGrower, SaysWhyThereAreNoVariations)
{
    PlantGrower grower;
    grower.vary({ { shared_scene(), { {}, 1, 7 } }, 3 });
    grower.settle();
    EXPECT_FALSE(grower.take_variations());
    EXPECT_TRUE(grower.take_variations().value().empty());
}

TEST(PlantGrower, SaysWhyThereIsNoPlant)
{
    PlantGrower grower;
    grower.grow({ shared_scene(), { {}, 1, 7 } });
    grower.settle();
    auto const plant = grower.take();
    ASSERT_TRUE(plant);
    ASSERT_FALSE(*plant);
    EXPECT_NE(plant->error().message.find("as it likes"), std::string::npos);
}

TEST(PlantGrower, MayGoWhileItGrows)
{
    auto const scene = shared_scene();
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        PlantGrower grower;
        grower.grow({ scene, { {}, seed } });
    }
    EXPECT_EQ(scene.use_count(), 1);
}

} // namespace
} // namespace tractus::view
