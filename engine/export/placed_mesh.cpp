#include "engine/export/placed_mesh.h"

#include "engine/base/check.h"

namespace tractus::exports {

static mesh::Mesh meshed(PlantToMesh const& source)
{
    if (auto const* const given = std::get_if<Plant const*>(&source.plant)) {
        CHECK(*given);
        return mesh::make_mesh(**given, source.options);
    }
    return mesh::make_mesh(std::get<std::function<Plant()>>(source.plant)(), source.options);
}

mesh::Mesh const& mesh_of(MeshSource const& source, std::optional<mesh::Mesh>& made)
{
    if (auto const* const given = std::get_if<mesh::Mesh const*>(&source)) {
        CHECK(*given);
        return **given;
    }
    if (made)
        return *made;
    if (auto const* const make = std::get_if<std::function<mesh::Mesh()>>(&source))
        made = (*make)();
    else if (auto const* const draw = std::get_if<std::function<Billboard()>>(&source))
        made = billboard_mesh((*draw)());
    else
        made = meshed(std::get<PlantToMesh>(source));
    return *made;
}

} // namespace tractus::exports
