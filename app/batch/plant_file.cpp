#include "app/batch/plant_file.h"

#include "engine/base/check.h"

namespace tractus::batch {

Result<WrittenFile> write_plant_file(Plant const& plant, std::string const& name,
                                     std::filesystem::path const& path,
                                     PlantFileOptions const& options)
{
    auto const* const format = plant_format_of(path);
    CHECK(format);
    return format->write({ name, &plant }, path, options);
}

Result<WrittenFile> write_mesh_file(mesh::Mesh const& mesh, std::string const& name,
                                    std::filesystem::path const& path,
                                    PlantFileOptions const& options)
{
    auto const* const format = plant_format_of(path);
    CHECK(format && format->has_triangles);
    return format->write({ name, &mesh }, path, options);
}

} // namespace tractus::batch
