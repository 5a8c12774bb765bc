#pragma once

#include "engine/mesh/extrusion.h"
#include "engine/mesh/tube.h"

#include <cstddef>

namespace tractus::mesh {

// Assigns the vertices of a tube or an extrusion to its sections: calls use(station, count) for
// each run of vertices, in the order in which write_tube() or write_extrusion() writes them. The
// vertices of end caps and tips belong to the first or last section. `vertices`: number of all
// vertices of the part.

template<typename Use>
void for_each_ring(Spine const& spine, TubePart const& part, std::size_t vertices, Use const& use)
{
    auto const sides = static_cast<std::size_t>(spine.sides);
    std::uint32_t const last_station = static_cast<std::uint32_t>(spine.stations.size()) - 1;
    bool const is_pointed = part.last == last_station && spine.tip == Spine::Tip::Point;
    if (part.first == 0 && spine.closed_base) {
        use(part.first, base_vertex_count(spine));
        vertices -= base_vertex_count(spine);
    }
    for (auto i = part.first; i <= (is_pointed ? part.last - 1 : part.last); ++i) {
        use(i, sides + 1);
        vertices -= sides + 1;
    }
    if (vertices > 0)
        use(last_station, vertices);
}

template<typename Use>
void for_each_ring(Extrusion const& extrusion, TubePart const& part, std::size_t vertices,
                   Use const& use)
{
    std::size_t const width = extrusion.sides + 1;
    for (int layer = 0; layer < (extrusion.is_sheet ? 2 : 1); ++layer)
        for (auto i = part.first; i <= part.last; ++i) {
            use(i, width);
            vertices -= width;
        }
    // The remaining vertices are those of the end caps. If there are two caps, each has half of
    // these vertices.
    bool const has_tip = part.last + 1 == extrusion.stations.size();
    auto const base = part.first > 0 ? 0 : has_tip ? vertices / 2 : vertices;
    if (base > 0)
        use(part.first, base);
    if (vertices > base)
        use(part.last, vertices - base);
}

} // namespace tractus::mesh
