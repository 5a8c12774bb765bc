#include "engine/mesh/mesh.h"

namespace tractus::mesh {

std::size_t Mesh::triangle_count() const
{
    std::size_t count = 0;
    for (auto const& surface : surfaces)
        count += surface.triangle_count();
    for (auto const& organ : organs)
        count += organ.prototype.triangle_count() * organ.instances.size();
    return count;
}

} // namespace tractus::mesh
