#pragma once

#include "engine/export/billboard.h"
#include "engine/mesh/make_mesh.h"
#include "engine/mesh/wind.h"

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tractus::exports {

// A plant whose triangles an exporter makes itself, piece by piece as it writes them: then they are
// never all in memory.
struct PlantToMesh {
    // The plant, or how to grow it when its turn comes: then only a few plants are in memory at a
    // time. The function is called for one plant after another, but not always on the same thread.
    std::variant<Plant const*, std::function<Plant()>> plant = static_cast<Plant const*>(nullptr);
    mesh::MeshOptions options {};
    // Where it is given, vertices and organs get what the wind needs (wind.h); .glb files only.
    std::optional<mesh::WindKey> wind {};
};

// Triangles, or how to make them when their turn comes. An exporter may call a function more than
// once and needs the same plant or mesh each time.
using MeshSource = std::variant<mesh::Mesh const*, std::function<mesh::Mesh()>, PlantToMesh,
                                std::function<Billboard()>>;

// A plant as it is seen from afar.
struct DetailLevel {
    MeshSource mesh = static_cast<mesh::Mesh const*>(nullptr);
    double least_coverage = 0; // As in PlacedMesh::least_coverage; less than the level before.
};

// One plant of an exported file: a name, a place, and its triangles.
struct PlacedMesh {
    std::string name = "plant";      // UTF-8; what is not becomes a replacement character.
    Vec3 position_mm = Vec3::Zero(); // Where the plant's origin stands, world frame.
    double rotation_rad = 0;         // About the world's +z, counter-clockwise from above.

    MeshSource mesh = static_cast<mesh::Mesh const*>(nullptr);

    // Levels that stand for the plant where it takes less of the screen's area than
    // `least_coverage`, 0 to 1, from the finest to the coarsest. Only .glb files have it.
    std::vector<DetailLevel> details {};
    double least_coverage = 0;
};

// The triangles of `source`. Where they have to be made they are put into `made`, unless it has
// them already. A billboard's come without its picture.
mesh::Mesh const& mesh_of(MeshSource const& source, std::optional<mesh::Mesh>& made);

} // namespace tractus::exports
