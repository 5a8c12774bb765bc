#include "engine/export/placed_mesh.h"

#include "engine/base/check.h"

namespace tractus {

Mesh const& mesh_of(PlacedMesh const& placed, std::optional<Mesh>& made)
{
    if (auto const* const given = std::get_if<Mesh const*>(&placed.mesh)) {
        CHECK(*given);
        return **given;
    }
    if (!made)
        made = std::get<std::function<Mesh()>>(placed.mesh)();
    return *made;
}

} // namespace tractus
