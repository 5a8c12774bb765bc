// Writes .glb files of every kind into a folder, to test them with the glTF validator. Usage:
// write_sample_glbs FOLDER
#include "engine/base/file.h"
#include "engine/export/glb_growth.h"
#include "engine/export/glb_writer.h"
#include "engine/export/stroke_glb.h"
#include "engine/export/texture.h"
#include "engine/mesh/level_of_detail.h"
#include "engine/mesh/make_mesh.h"
#include "engine/variation/growth.h"
#include "tests/engine/mesh/sample_plants.h"
#include "tests/engine/stroke/strokes.h"
#include "tests/engine/variation/plans.h"

#include <fmt/core.h>
#include <functional>
#include <vector>

namespace tractus::exports {
namespace {

// Returns a plant with organs and materials of all kinds, polygons, tips of zero radius and sharp
// bends.
Plant odd_plant()
{
    Plant plant = mesh::single_axis(6, 5, 0);
    plant.node_position_mm = { { 0, 0, 0 },  { 0, 0, 50 },  { 0, 0, 50 }, { 0, 0, 10 },
                               { 50, 0, 0 }, { 50, 50, 0 }, { 50, 50, 0 } };
    plant.segment_material = { 0, 0, 0, 1, 1, 0 };
    plant.materials
        = { Material {},
            { .name = "stem \"green\"", .kind = Material::Kind::Stem },
            { .name = "leaf", .kind = Material::Kind::Leaf, .translucency = 0.5f },
            { .name = "petal", .kind = Material::Kind::Petal, .base_color { 1, 0.5f, 0.7f } },
            { .name = "fruit",
              .kind = Material::Kind::Solid,
              .base_color { 0.8f, 0, 0 },
              .roughness = 0.2f } };
    plant.organ_shapes = {
        { .name = "leaf", .material = 2, .petiole_mm = 10, .lobes = 0.5, .lobe_count = 3 },
        { .name = "petal", .material = 3, .tip_sharpness = 0 },
        { .name = "needle",
          .kind = OrganShape::Kind::Needle,
          .material = 2,
          .length_mm = 20,
          .width_mm = 1 },
        { .name = "disc",
          .kind = OrganShape::Kind::Disc,
          .material = 4,
          .length_mm = 5,
          .width_mm = 20 },
        { .name = "ball",
          .kind = OrganShape::Kind::Ball,
          .material = 4,
          .length_mm = 10,
          .width_mm = 10 },
    };
    for (OrganShapeId shape = 0; shape < 5; ++shape)
        plant.organs.push_back({ .shape = shape,
                                 .segment = 0,
                                 .position_mm = { 10.0 * shape, 5, 40 },
                                 .orientation = Quat(1, 0.1 * shape, 0.3, 0.2).normalized() });
    plant.polygon_vertices_mm = { { 0, 0, 0 }, { 50, 0, -20 }, { 0, 0, 40 }, { -50, 0, -20 } };
    plant.polygons = { { .first_vertex = 0, .vertex_count = 4, .segment = 0, .material = 2 } };
    return plant;
}

// Returns a tree with two coarser levels of detail and a billboard.
PlacedMesh with_details(Plant const& plant)
{
    PlacedMesh placed { .name = "far", .mesh = PlantToMesh { .plant = &plant } };
    placed.rotation_rad = 1;
    placed.min_coverage = 0.4;
    for (double const share : { 0.5, 0.2 })
        placed.details.push_back(
            { PlantToMesh { .plant
                            = [&plant, share] { return mesh::coarser_plant(plant, {}, share); },
                            .options = mesh::coarser_options({}, share) },
              0.4 * share });
    placed.details.push_back(
        { std::function<Billboard()>([] {
              return Billboard { png_bytes(leaf_picture()), { 0, 0, 500 }, 1000 };
          }),
          0 });
    return placed;
}

// Returns the line "FILE PLANTS TRIANGLES" with the numbers that the writer reports. Programs that
// import the file compare their numbers with these.
std::string counts_line(std::string_view file, std::size_t plants, std::uint64_t triangles)
{
    return fmt::format("{} {} {}\n", file, plants, triangles);
}

// Writes an animation of a tree that grows and bends in the wind and under its weight.
Result<void> write_growth(std::filesystem::path const& path, std::string& counts)
{
    auto const plan = variation::plan_of(mesh::sample_tree(4), { .sag = 2 }, { 0.5, 0, 0 });
    variation::Grower grower(plan);
    Plant const whole = grower.grow({ 1, 0 });
    mesh::AgedMesh const mesh(whole);
    GrowthFilm film { .name = "grows", .mesh = &mesh, .ages = { 0.25, 0.5, 0.75, 1 } };
    film.plant_at = [&](double age) -> Plant const& { return grower.grow({ 1, 0 }, age); };
    return write_file(path, [&](std::ostream& out) -> Result<void> {
        counts += counts_line(path.filename().string(), 1, TRY(write_glb(out, film)).triangles);
        return {};
    });
}

using Write = std::function<Result<void>(char const* name, std::span<PlacedMesh const> plants,
                                         GlbOptions const& options)>;

Result<void> write_compressed(Write const& write, std::vector<PlacedMesh> const& plants)
{
    using Options = GlbOptions;
    Options options { .vertices = Options::Vertices::Compressed };
    TRY(write("compressed.glb", plants, options));
    options.organs = Options::Organs::Instanced;
    TRY(write("instanced_compressed.glb", plants, options));
    options.organs = Options::Organs::Nodes;
    return write("nodes_compressed.glb", plants, options);
}

Result<void> write_compressed_wind(Write const& write, std::vector<PlacedMesh> const& plants)
{
    using Options = GlbOptions;
    Options options { .vertices = Options::Vertices::Compressed };
    TRY(write("wind_compressed.glb", plants, options));
    options.wind = Options::Wind::TextureCoordinates;
    TRY(write("wind_uv_compressed.glb", plants, options));
    options.wind = Options::Wind::Attributes;
    options.organs = Options::Organs::Instanced;
    return write("wind_instanced_compressed.glb", plants, options);
}

Result<void> write_details(Write const& write, std::vector<PlacedMesh> const& plants)
{
    using Vertices = GlbOptions::Vertices;
    TRY(write("details.glb", plants, {}));
    TRY(write("details_quantized.glb", plants, { .vertices = Vertices::Quantized }));
    return write("details_compressed.glb", plants, { .vertices = Vertices::Compressed });
}

Result<void> write_samples(std::filesystem::path const& folder)
{
    std::filesystem::create_directories(folder);
    auto const odd = odd_plant();
    mesh::Mesh const odd_mesh = mesh::make_mesh(odd);
    std::vector<PlacedMesh> collection;
    collection.push_back({ .name = "odd", .position_mm = { 0, -1000, 0 }, .mesh = &odd_mesh });
    for (std::uint64_t seed = 0; seed < 3; ++seed)
        collection.push_back(
            { .name = fmt::format("tree {}", seed),
              .position_mm = { 3000.0 * static_cast<double>(seed), 0, 0 },
              .rotation_rad = static_cast<double>(seed),
              .mesh = [seed] { return mesh::make_mesh(mesh::sample_tree(seed)); } });
    // The mesh of this plant is made while it is written.
    PlacedMesh const streamed { .name = "odd", .mesh = PlantToMesh { .plant = &odd } };
    collection.push_back(streamed);
    // The mesh has more than 65,535 vertices, so it needs 32-bit indices.
    PlacedMesh const fine { .mesh = [] {
        return mesh::make_mesh(mesh::sample_tree(9), { .min_sides = 40, .max_sides = 64 });
    } };

    using Options = GlbOptions;
    std::string counts;
    auto const write
        = [&](char const* name, std::span<PlacedMesh const> plants, Options const& options) {
              return write_file(folder / name, [&](std::ostream& out) -> Result<void> {
                  auto const summary = TRY(write_glb(out, plants, options));
                  counts += counts_line(name, plants.size(), summary.triangles);
                  return {};
              });
          };
    TRY(write("collection.glb", collection, {}));
    TRY(write("quantized.glb", collection, { .vertices = Options::Vertices::Quantized }));
    TRY(write("instanced.glb", collection, { .organs = Options::Organs::Instanced }));
    TRY(write("instanced_quantized.glb", collection,
              { .organs = Options::Organs::Instanced, .vertices = Options::Vertices::Quantized }));
    TRY(write_compressed(write, collection));
    TRY(write("fine_compressed.glb", std::span(&fine, 1),
              { .vertices = Options::Vertices::Compressed }));
    TRY(write("nodes.glb", collection,
              { .organs = Options::Organs::Nodes, .textures = Options::Textures::None }));
    TRY(write("fine.glb", std::span(&fine, 1), {}));
    auto const tree = mesh::sample_tree(5);
    TRY(write_details(write, { with_details(tree), with_details(odd) }));
    for (auto& plant : collection)
        if (auto* const meshed = std::get_if<PlantToMesh>(&plant.mesh))
            meshed->wind = mesh::WindKey {};
    TRY(write("wind.glb", collection, { .vertices = Options::Vertices::Quantized }));
    TRY(write_compressed_wind(write, collection));
    TRY(write("wind_instanced.glb", collection, { .organs = Options::Organs::Instanced }));
    TRY(write("wind_uv.glb", collection, { .wind = Options::Wind::TextureCoordinates }));
    TRY(write("wind_colour.glb", collection, { .wind = Options::Wind::Colours }));
    TRY(write("empty.glb", {}, {}));
    TRY(write_growth(folder / "growth.glb", counts));
    TRY(write_file(folder / "strokes.glb", [](std::ostream& out) {
        return write_strokes_glb(
            out, std::vector { stroke_of(s_curve(50)), stroke_of(trembling(s_curve(3), 2)) });
    }));
    return write_file(folder / "counts.txt", counts);
}

} // namespace
} // namespace tractus::exports

int main(int argument_count, char** arguments)
{
    if (argument_count != 2) {
        fmt::print(stderr, "usage: write_sample_glbs FOLDER\n");
        return 2;
    }
    auto const result = tractus::exports::write_samples(arguments[1]);
    if (!result)
        fmt::print(stderr, "error: {}\n", result.error().message);
    return result ? 0 : 1;
}
