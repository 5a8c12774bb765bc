// Writes one plant in every format of triangles into a folder, for other programs to read. Usage:
// write_sample_formats FOLDER
//
// FOLDER/counts.txt then has lines "FILE TRIANGLES".
#include "engine/base/file.h"
#include "engine/export/obj_writer.h"
#include "engine/export/ply_writer.h"
#include "engine/export/stl_writer.h"
#include "engine/export/usd_writer.h"
#include "engine/mesh/closed_shell.h"
#include "engine/mesh/make_mesh.h"
#include "tests/engine/mesh/sample_plants.h"

#include <filesystem>
#include <fmt/format.h>
#include <functional>

namespace tractus::exports {
namespace {

// A tree with leaves that are stretched, and some that are mirrored.
Plant leafy_tree()
{
    auto plant = mesh::sample_tree(1);
    for (std::size_t i = 0; i < plant.organs.size(); ++i) {
        auto const x = static_cast<float>(i % 5);
        plant.organs[i].scale = { 0.5f + 0.1f * x, 0.8f, i % 7 == 0 ? -1.0f : 1.0f };
    }
    return plant;
}

Result<void> write_usda_files(PlacedMesh const& placed, std::filesystem::path const& path,
                              UsdOptions::Organs organs)
{
    std::vector<PictureFile> pictures;
    TRY(write_file(path, [&](std::ostream& out) -> Result<void> {
        pictures = TRY(write_usda(out, { &placed, 1 }, path.stem().string(), { organs }));
        return {};
    }));
    for (auto const& [name, bytes] : pictures)
        TRY(write_file(path.parent_path() / name, bytes));
    return {};
}

Result<void> write_samples(std::filesystem::path const& folder)
{
    auto const plant = leafy_tree();
    auto const mesh = mesh::make_mesh(plant);
    auto const surfaces = mesh::closed_surfaces(mesh::solid_parts(plant, {}));
    auto const shell
        = TRY(mesh::closed_shell(mesh::solid_parts(plant, { .least_thickness_mm = 24 })));
    PlacedMesh const placed { .name = "tree", .mesh = &mesh };
    TRY(write_usda_files(placed, folder / "instanced.usda", UsdOptions::Organs::Instanced));
    TRY(write_usda_files(placed, folder / "merged.usda", UsdOptions::Organs::Merged));
    using Write = std::function<Result<void>(std::ostream&)>;
    std::pair<char const*, Write> const files[] {
        { "tree.obj",
          [&](std::ostream& out) {
              return write_obj(out, { &placed, 1 });
          } },
        { "open.ply", [&](std::ostream& out) { return write_ply(out, mesh); } },
        { "shell.ply", [&](std::ostream& out) { return write_ply(out, shell, plant.materials); } },
        { "parts.stl", [&](std::ostream& out) { return write_stl(out, surfaces); } },
        { "shell.stl", [&](std::ostream& out) { return write_stl(out, shell); } },
    };
    for (auto const& [name, write] : files)
        TRY(write_file(folder / name, write));
    auto const shown = mesh.triangle_count();
    return write_file(folder / "counts.txt",
                      fmt::format("instanced.usda {0}\nmerged.usda {0}\ntree.obj {0}\n"
                                  "open.ply {0}\nshell.ply {1}\nparts.stl {2}\nshell.stl {1}\n",
                                  shown, shell.triangles.size(), surfaces.triangles.size()));
}

} // namespace
} // namespace tractus::exports

int main(int count, char** arguments)
{
    auto const written = count == 2 ? tractus::exports::write_samples(arguments[1])
                                    : tractus::fail(tractus::Fault::User, "give a folder");
    if (!written)
        fmt::print("{}\n", written.error().message);
    return written ? 0 : 1;
}
