#include "app/plants/plant_file.h"

#include "app/plants/pictures.h"
#include "drivers/file.h"
#include "engine/export/glb_writer.h"
#include "engine/export/obj_writer.h"
#include "engine/mesh/make_mesh.h"

namespace tractus {

static Result<std::uint64_t> write_plant_glb(Plant const& plant, std::string const& name,
                                             std::filesystem::path const& path,
                                             GlbOptions const& options)
{
    // Meshed while it is written: plants may be large.
    PlacedMesh const placed { .name = name, .mesh = PlantToMesh { .plant = &plant } };
    std::uint64_t triangles = 0;
    auto const write = [&](std::ostream& out) -> Result<void> {
        triangles = TRY(write_glb(out, { &placed, 1 }, options)).triangles;
        return {};
    };
    TRY(write_file(path, write));
    return triangles;
}

Result<std::uint64_t> write_plant_file(Plant const& plant, std::string const& name,
                                       std::filesystem::path const& path,
                                       PlantFileOptions const& options)
{
    if (path.extension() == ".glb")
        return write_plant_glb(plant, name, path, options.glb);
    auto const mesh = make_mesh(plant);
    if (path.extension() == ".obj") {
        PlacedMesh const placed { .name = name, .mesh = &mesh };
        TRY(write_file(path, [&](std::ostream& out) { return write_obj(out, { &placed, 1 }); }));
    } else {
        auto pictures = TRY(PictureMaker::create());
        auto const picture = pictures.plant(mesh, {}, options.camera);
        TRY(write_file(path, [&](std::ostream& out) { return write_png(out, picture); }));
    }
    return mesh.triangle_count();
}

} // namespace tractus
