#pragma once

#include "tests/engine/mesh/edge_count.h"

#include <cstring>
#include <string_view>
#include <vector>

namespace tractus::mesh {

// The corners of the triangles of a binary STL file.
inline std::vector<Corners> stl_triangles(std::string_view bytes)
{
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    std::vector<Corners> triangles(count);
    for (std::size_t i = 0; i < count && 84 + 50 * (i + 1) <= bytes.size(); ++i)
        std::memcpy(&triangles[i], bytes.data() + 84 + 50 * i + 12, sizeof triangles[i]);
    return triangles;
}

} // namespace tractus::mesh
