#include "app/batch/plant_format.h"

#include "app/batch/pictures.h"
#include "app/batch/plant_page.h"
#include "engine/base/file.h"
#include "engine/export/obj_writer.h"
#include "engine/export/ply_writer.h"
#include "engine/export/stl_writer.h"
#include "engine/mesh/closed_shell.h"
#include "engine/mesh/make_mesh.h"
#include "engine/mesh/mesh_measures.h"
#include "engine/mesh/solid_parts.h"
#include "engine/plant/mtg.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <functional>
#include <sstream>

namespace tractus::batch {

namespace {

namespace fs = std::filesystem;

Plant const* plant_of(PlantContent const& content)
{
    auto const* const plant = std::get_if<Plant const*>(&content.plant);
    return plant ? *plant : nullptr;
}

// Returns the mesh of the content. If it is a plant, the mesh is made and stored in `made`.
mesh::Mesh const& mesh_of(PlantContent const& content, std::optional<mesh::Mesh>& made)
{
    if (auto const* const plant = plant_of(content))
        return made ? *made : made.emplace(mesh::make_mesh(*plant));
    return *std::get<mesh::Mesh const*>(content.plant);
}

// The content for writers that convert a plant to a mesh while they write the file, as large plants
// have large meshes.
exports::PlacedMesh placed(PlantContent const& content)
{
    if (auto const* const plant = plant_of(content))
        return { .name = content.name, .mesh = exports::PlantToMesh { .plant = plant } };
    return { .name = content.name, .mesh = std::get<mesh::Mesh const*>(content.plant) };
}

Result<WrittenFile> write_page_file(PlantContent const& content, fs::path const& path,
                                    PlantFileOptions const& options)
{
    auto const mesh = placed(content);
    WrittenFile written;
    auto const write = [&](std::ostream& out) -> Result<void> {
        written.triangles = TRY(write_page(out, content.name, { &mesh, 1 }, options.glb)).triangles;
        return {};
    };
    TRY(write_file(path, write));
    return written;
}

Result<WrittenFile> write_glb_file(PlantContent const& content, fs::path const& path,
                                   PlantFileOptions const& options)
{
    auto const mesh = placed(content);
    WrittenFile written;
    auto const write = [&](std::ostream& out) -> Result<void> {
        written.triangles = TRY(exports::write_glb(out, { &mesh, 1 }, options.glb)).triangles;
        return {};
    };
    TRY(write_file(path, write));
    return written;
}

Result<void> write_pictures(std::vector<exports::PictureFile> const& pictures, fs::path const& path)
{
    for (auto const& [name, bytes] : pictures)
        TRY(write_file(path.parent_path() / name, bytes));
    return {};
}

// Writes an .obj file last, after the .mtl file and images that it refers to.
Result<WrittenFile> write_obj_file(PlantContent const& content, fs::path const& path,
                                   PlantFileOptions const&)
{
    std::optional<mesh::Mesh> made;
    exports::PlacedMesh const placed { .name = content.name, .mesh = &mesh_of(content, made) };
    auto library = path;
    library.replace_extension(".mtl");
    std::ostringstream materials;
    auto const pictures = TRY(exports::write_mtl(materials, { &placed, 1 }, path.stem().string()));
    TRY(write_pictures(pictures, path));
    TRY(write_file(library, materials.str()));
    TRY(write_file(path, [&](std::ostream& out) {
        return exports::write_obj(out, { &placed, 1 }, library.filename().string());
    }));
    return WrittenFile { mesh_of(content, made).triangle_count() };
}

// The file gets its name after its pictures.
Result<WrittenFile> write_usda_file(PlantContent const& content, fs::path const& path,
                                    PlantFileOptions const& options)
{
    std::optional<mesh::Mesh> made;
    exports::PlacedMesh const placed { .name = content.name, .mesh = &mesh_of(content, made) };
    auto const write = [&](std::ostream& out) -> Result<void> {
        auto const pictures
            = TRY(exports::write_usda(out, { &placed, 1 }, path.stem().string(), options.usd));
        return write_pictures(pictures, path);
    };
    TRY(write_file(path, write));
    return WrittenFile { mesh_of(content, made).triangle_count() };
}

// The factor that gives the content the options' height.
double scale_of(PlantContent const& content, SolidFileOptions const& options)
{
    if (!options.height_mm)
        return 1;
    auto const* const plant = plant_of(content);
    auto const box
        = plant ? bounds(*plant) : mesh::bounds(*std::get<mesh::Mesh const*>(content.plant));
    double const height_mm = box.empty() ? 0 : box.max_mm.z() - box.min_mm.z();
    return height_mm > 0 ? *options.height_mm / height_mm : 1;
}

mesh::SolidParts parts_of(PlantContent const& content, SolidFileOptions const& options)
{
    using Organs = mesh::SolidOptions::Organs;
    mesh::SolidOptions const solid { .scale = scale_of(content, options),
                                     .least_thickness_mm
                                     = options.least_thickness_mm.value_or(kPrintableThickness_mm),
                                     .organs
                                     = options.without_leaves ? Organs::LeftOut : Organs::Solid };
    if (auto const* const plant = plant_of(content))
        return mesh::solid_parts(*plant, solid);
    return mesh::solid_parts(*std::get<mesh::Mesh const*>(content.plant), solid);
}

std::string describe_closed(mesh::ClosedMesh const& mesh, bool is_watertight)
{
    auto const count = mesh::count_surfaces(mesh);
    if (count == 0)
        return "the surface is empty: nothing of the plant is left to print";
    if (count == 1)
        return "the surface is closed, in one shell";
    if (is_watertight)
        return fmt::format("the surface is closed, in {} shells that do not touch each other",
                           count);
    return fmt::format("the surface is closed, in {} shells that overlap, one for each branch and "
                       "leaf; --watertight makes one of them",
                       count);
}

// Makes a plant solid and passes it to `write`.
Result<WrittenFile>
write_solid_file(PlantContent const& content, fs::path const& path, SolidFileOptions const& options,
                 std::function<Result<void>(std::ostream&, mesh::ClosedMesh const&)> const& write)
{
    auto const parts = parts_of(content, options);
    auto const mesh
        = options.is_watertight ? TRY(mesh::closed_shell(parts)) : mesh::closed_surfaces(parts);
    TRY(write_file(path, [&](std::ostream& out) { return write(out, mesh); }));
    return WrittenFile { mesh.triangles.size(), describe_closed(mesh, options.is_watertight) };
}

Result<WrittenFile> write_stl_file(PlantContent const& content, fs::path const& path,
                                   PlantFileOptions const& options)
{
    return write_solid_file(content, path, options.solid, exports::write_stl);
}

Result<WrittenFile> write_ply_file(PlantContent const& content, fs::path const& path,
                                   PlantFileOptions const& options)
{
    std::optional<mesh::Mesh> made;
    if (!options.solid.closes()) {
        auto const& mesh = mesh_of(content, made);
        TRY(write_file(path, [&](std::ostream& out) { return exports::write_ply(out, mesh); }));
        return WrittenFile { mesh.triangle_count(),
                             "the surface is open, as it is shown; --watertight closes it" };
    }
    auto const* const plant = plant_of(content);
    auto const& materials = plant ? plant->materials : mesh_of(content, made).materials;
    return write_solid_file(content, path, options.solid,
                            [&](std::ostream& out, mesh::ClosedMesh const& mesh) {
                                return exports::write_ply(out, mesh, materials);
                            });
}

Result<WrittenFile> write_mtg_file(PlantContent const& content, fs::path const& path,
                                   PlantFileOptions const&)
{
    TRY(write_file(path, [&](std::ostream& out) -> Result<void> {
        write_mtg(out, *plant_of(content));
        return {};
    }));
    return WrittenFile {};
}

Result<WrittenFile> write_picture_file(PlantContent const& content, fs::path const& path,
                                       PlantFileOptions const& options)
{
    std::optional<mesh::Mesh> made;
    auto const& mesh = mesh_of(content, made);
    auto pictures = TRY(PictureMaker::create());
    auto const picture = pictures.plant(mesh, options.picture, options.camera);
    TRY(write_file(path, [&](std::ostream& out) { return render::write_png(out, picture); }));
    return WrittenFile { mesh.triangle_count() };
}

constexpr std::array kFormats {
    PlantFormat { ".glb", "glTF", true, write_glb_file },
    PlantFormat { ".obj", "Wavefront OBJ", true, write_obj_file },
    PlantFormat { ".usda", "USD", true, write_usda_file },
    PlantFormat { ".ply", "coloured triangles", true, write_ply_file },
    PlantFormat { ".stl", "for a 3D printer", true, write_stl_file },
    PlantFormat { ".mtg", "a multiscale tree graph", false, write_mtg_file },
    PlantFormat { ".html", "a page that turns in a browser", true, write_page_file },
    PlantFormat { ".png", "a picture", true, write_picture_file },
};

} // namespace

std::span<PlantFormat const> plant_formats()
{
    return kFormats;
}

PlantFormat const* plant_format_of(fs::path const& path)
{
    auto const ending = path.extension().string();
    auto const* const found
        = std::find_if(kFormats.begin(), kFormats.end(),
                       [&](PlantFormat const& format) { return format.ending == ending; });
    return found == kFormats.end() ? nullptr : &*found;
}

bool is_plant_file(fs::path const& path)
{
    return plant_format_of(path) != nullptr;
}

std::vector<std::string> plant_endings()
{
    std::vector<std::string> endings;
    for (auto const& format : kFormats)
        endings.emplace_back(format.ending);
    return endings;
}

std::vector<std::string> mesh_endings()
{
    std::vector<std::string> endings;
    for (auto const& format : kFormats)
        if (format.has_triangles)
            endings.emplace_back(format.ending);
    return endings;
}

std::string listed(std::vector<std::string> const& endings)
{
    return fmt::format("{} or {}", fmt::join(endings.begin(), endings.end() - 1, ", "),
                       endings.back());
}

} // namespace tractus::batch
