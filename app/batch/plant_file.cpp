#include "app/batch/plant_file.h"

#include "app/batch/pictures.h"
#include "engine/base/file.h"
#include "engine/export/glb_writer.h"
#include "engine/export/obj_writer.h"
#include "engine/mesh/make_mesh.h"
#include "engine/plant/mtg.h"

#include <sstream>

namespace tractus::batch {

static Result<std::uint64_t> write_glb_file(exports::PlacedMesh const& placed,
                                            std::filesystem::path const& path,
                                            exports::GlbOptions const& options)
{
    std::uint64_t triangles = 0;
    auto const write = [&](std::ostream& out) -> Result<void> {
        triangles = TRY(exports::write_glb(out, { &placed, 1 }, options)).triangles;
        return {};
    };
    TRY(write_file(path, write));
    return triangles;
}

// Writes an .obj file last, after the .mtl file and images that it refers to.
static Result<void> write_plant_obj(exports::PlacedMesh const& placed,
                                    std::filesystem::path const& path)
{
    auto library = path;
    library.replace_extension(".mtl");
    std::ostringstream materials;
    auto const pictures = TRY(exports::write_mtl(materials, { &placed, 1 }, path.stem().string()));
    for (auto const& [name, png] : pictures)
        TRY(write_file(path.parent_path() / name, png));
    TRY(write_file(library, materials.str()));
    return write_file(path, [&](std::ostream& out) {
        return exports::write_obj(out, { &placed, 1 }, library.filename().string());
    });
}

Result<std::uint64_t> write_plant_file(Plant const& plant, std::string const& name,
                                       std::filesystem::path const& path,
                                       PlantFileOptions const& options)
{
    // The plant is converted to a mesh while the file is written, as large plants have large
    // meshes.
    if (path.extension() == ".glb")
        return write_glb_file({ .name = name, .mesh = exports::PlantToMesh { .plant = &plant } },
                              path, options.glb);
    if (path.extension() == ".mtg") {
        TRY(write_file(path, [&](std::ostream& out) -> Result<void> {
            write_mtg(out, plant);
            return {};
        }));
        return 0;
    }
    return write_mesh_file(mesh::make_mesh(plant), name, path, options);
}

Result<std::uint64_t> write_mesh_file(mesh::Mesh const& mesh, std::string const& name,
                                      std::filesystem::path const& path,
                                      PlantFileOptions const& options)
{
    if (path.extension() == ".glb")
        return write_glb_file({ .name = name, .mesh = &mesh }, path, options.glb);
    if (path.extension() == ".obj") {
        TRY(write_plant_obj({ .name = name, .mesh = &mesh }, path));
    } else {
        auto pictures = TRY(PictureMaker::create());
        auto const picture = pictures.plant(mesh, options.picture, options.camera);
        TRY(write_file(path, [&](std::ostream& out) { return render::write_png(out, picture); }));
    }
    return mesh.triangle_count();
}

} // namespace tractus::batch
