#pragma once

#include "engine/mesh/mesh.h"

#include <functional>
#include <optional>
#include <string>
#include <variant>

namespace tractus {

// One plant of an exported file: a name, a place, and its triangles.
struct PlacedMesh {
    std::string name = "plant";      // UTF-8; what is not becomes a replacement character.
    Vec3 position_mm = Vec3::Zero(); // Where the plant's origin stands, world frame.
    double rotation_rad = 0;         // About the world's +z, counter-clockwise from above.

    // The triangles, or how to make them when their turn comes: then only one plant is in memory at
    // a time. An exporter may call the function more than once and needs the same mesh each time.
    std::variant<Mesh const*, std::function<Mesh()>> mesh = static_cast<Mesh const*>(nullptr);
};

// The triangles of `placed`. Where they have to be made they are put into `made`, unless it has
// them already.
Mesh const& mesh_of(PlacedMesh const& placed, std::optional<Mesh>& made);

} // namespace tractus
