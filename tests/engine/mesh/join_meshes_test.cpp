#include "engine/mesh/join_meshes.h"

#include "engine/mesh/make_mesh.h"
#include "engine/plant/join_plants.h"
#include "tests/engine/mesh/sample_plants.h"

#include <gtest/gtest.h>

namespace tractus::mesh {
namespace {

// Two joined meshes must have the triangles of a mesh that is made of both plants together.
TEST(JoinMeshes, GivesTheMeshOfBothPlants)
{
    Vec3 const moved_mm(500, -20, 0);
    auto const plant = sample_tree(7);
    auto both = plant;
    append_plant(both, plant, moved_mm);
    auto const expected = make_mesh(both);
    auto joined = make_mesh(plant);
    append_mesh(joined, make_mesh(plant), moved_mm.cast<float>());
    EXPECT_EQ(joined.triangle_count(), expected.triangle_count());
    ASSERT_EQ(joined.materials.size(), expected.materials.size());
    ASSERT_EQ(joined.surfaces.size(), expected.surfaces.size());
    for (std::size_t i = 0; i < joined.surfaces.size(); ++i) {
        auto const& surface = joined.surfaces[i];
        auto const& wanted = expected.surfaces[i];
        EXPECT_EQ(surface.material, wanted.material);
        ASSERT_EQ(surface.positions_mm.size(), wanted.positions_mm.size());
        for (std::size_t k = 0; k < surface.positions_mm.size(); ++k)
            EXPECT_LT((surface.positions_mm[k] - wanted.positions_mm[k]).norm(), 1e-3f);
    }
    ASSERT_EQ(joined.organs.size(), expected.organs.size());
    for (std::size_t i = 0; i < joined.organs.size(); ++i) {
        EXPECT_EQ(joined.organs[i].shape, expected.organs[i].shape);
        EXPECT_EQ(joined.organs[i].instances.size(), expected.organs[i].instances.size());
        EXPECT_EQ(joined.organs[i].prototype.material, expected.organs[i].prototype.material);
    }
}

} // namespace
} // namespace tractus::mesh
