#include "engine/export/glb_reader.h"
#include "engine/export/glb_writer.h"
#include "tests/engine/export/glb_of.h"
#include "tests/engine/mesh/random_plants.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sstream>

namespace tractus::exports {
namespace {

// Fixes the seed of the property tests, unless the environment variable RC_PARAMS sets other
// parameters.
[[maybe_unused]] bool const has_parameters
    = setenv("RC_PARAMS", "seed=1 max_success=30", 0) == 0; // NOLINT(concurrency-mt-unsafe)

rc::Gen<GlbOptions> random_glb_options()
{
    using Options = GlbOptions;
    return rc::gen::apply(
        [](Options::Organs organs, bool quantized) {
            return Options { .organs = organs,
                             .textures = Options::Textures::None,
                             .vertices = quantized ? Options::Vertices::Quantized
                                                   : Options::Vertices::Float };
        },
        rc::gen::element(Options::Organs::Merged, Options::Organs::Instanced,
                         Options::Organs::Nodes),
        rc::gen::arbitrary<bool>());
}

// Form in which plants are given to the .glb writer.
enum class Given { AsMeshes, AsMeshFunctions, AsPlants, AsPlantFunctions };

std::vector<PlacedMesh> placed_plants(std::vector<Plant> const& plants,
                                      std::vector<mesh::Mesh> const& meshes, Given given)
{
    std::vector<PlacedMesh> placed(plants.size());
    for (std::size_t i = 0; i < plants.size(); ++i) {
        auto& mesh = placed[i].mesh;
        switch (given) {
        case Given::AsMeshes:
            mesh = &meshes[i];
            break;
        case Given::AsMeshFunctions:
            mesh = [&plants, i] { return mesh::make_mesh(plants[i]); };
            break;
        case Given::AsPlants:
            mesh = PlantToMesh { .plant = &plants[i] };
            break;
        case Given::AsPlantFunctions:
            mesh = PlantToMesh { .plant = [&plants, i] { return plants[i]; } };
            break;
        }
    }
    return placed;
}

RC_GTEST_PROP(GlbProperties, IsTheSameWhoeverMeshesOnAnyNumberOfThreads, ())
{
    std::vector<Plant> plants(*rc::gen::inRange<std::size_t>(0, 4));
    std::vector<mesh::Mesh> meshes;
    for (auto& plant : plants) {
        plant = *mesh::random_plants();
        meshes.push_back(mesh::make_mesh(plant));
    }
    auto options = *random_glb_options();
    // Quantisation depends on the bounding box. That of a mesh is tighter than that of its plant,
    // so unquantised vertices are compared.
    options.vertices = GlbOptions::Vertices::Float;
    auto const write = [&](Given given) {
        return [&, given] { return glb_of(placed_plants(plants, meshes, given), options); };
    };
    auto const expected = mesh::on_threads(1, write(Given::AsMeshes));
    for (int const threads : { 1, 2, 5 })
        for (auto const given :
             { Given::AsMeshes, Given::AsMeshFunctions, Given::AsPlants, Given::AsPlantFunctions })
            RC_ASSERT(mesh::on_threads(threads, write(given)) == expected);
}

RC_GTEST_PROP(GlbProperties, QuantizedFilesAreTheSameOnAnyNumberOfThreads, ())
{
    auto const plant = *mesh::random_plants();
    auto options = *random_glb_options();
    options.vertices = GlbOptions::Vertices::Quantized;
    PlacedMesh const placed { .mesh = PlantToMesh { .plant = &plant } };
    auto const write = [&] { return glb_of(std::span(&placed, 1), options); };
    auto const expected = mesh::on_threads(1, write);
    RC_ASSERT(mesh::on_threads(2, write) == expected);
    RC_ASSERT(mesh::on_threads(5, write) == expected);
}

RC_GTEST_PROP(GlbProperties, QuantizedVerticesAreNearTheRealOnes, ())
{
    auto plant = *mesh::random_plants();
    RC_PRE(!plant.axes.empty());
    plant.organs.clear(); // An organ that occurs once would be read as a part of the surfaces.
    auto const mesh = mesh::make_mesh(plant);
    PlacedMesh const placed { .mesh = PlantToMesh { .plant = &plant } };
    auto const bytes
        = glb_of(std::span(&placed, 1), { .vertices = GlbOptions::Vertices::Quantized });
    auto const read = read_glb(bytes);
    RC_ASSERT(read.has_value());
    RC_ASSERT(read->surfaces.size() == mesh.surfaces.size());
    Bounds box;
    for (auto const& surface : mesh.surfaces)
        for (auto const& position : surface.positions_mm)
            box.add(position.cast<double>());
    // Tolerance: half a quantisation step, plus the rounding of floats. The box that is quantised
    // may be larger than the mesh's by two radii of an axis.
    auto const tolerance_mm
        = static_cast<float>(((box.max_mm - box.min_mm).maxCoeff() + 80) / 65532 * 0.9 + 1e-3);
    for (std::size_t s = 0; s < mesh.surfaces.size(); ++s) {
        auto const& expected = mesh.surfaces[s];
        auto const& actual = read->surfaces[s];
        RC_ASSERT(std::ranges::equal(actual.indices, expected.indices));
        for (std::size_t i = 0; i < expected.positions_mm.size(); ++i) {
            RC_ASSERT((actual.positions_mm[i] - expected.positions_mm[i]).norm() < tolerance_mm);
            RC_ASSERT((actual.normals[i] - expected.normals[i]).norm() < 0.01f);
        }
    }
}

} // namespace
} // namespace tractus::exports
