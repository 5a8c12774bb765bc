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

// A plant that the exporter meshes itself. It does so piece by piece while writing, so that the
// plant's triangles are never all in memory.
struct PlantToMesh {
    // The plant, or a function that grows it when it is needed, so that only a few plants are in
    // memory at a time. The functions of several plants are called one after another, but possibly
    // on different threads.
    std::variant<Plant const*, std::function<Plant()>> plant = static_cast<Plant const*>(nullptr);
    mesh::MeshOptions options {};
    // If it has a value, vertices and organs get wind data (wind.h); in .glb files only.
    std::optional<mesh::WindKey> wind {};
};

// The triangles of a plant: a mesh, a function that makes the mesh or billboard when it is needed,
// or a plant to be meshed. An exporter may call a function several times; it must return the same
// result each time.
using MeshSource = std::variant<mesh::Mesh const*, std::function<mesh::Mesh()>, PlantToMesh,
                                std::function<Billboard()>>;

// A level of detail of a plant.
struct DetailLevel {
    MeshSource mesh = static_cast<mesh::Mesh const*>(nullptr);
    // Share of the screen's area, 0 to 1, below which the next level replaces this one. Must be
    // less than that of the level before.
    double min_coverage = 0;
};

// One plant of an exported file: its name, position, rotation and triangles.
struct PlacedMesh {
    std::string name = "plant";      // Name in UTF-8; invalid bytes become replacement characters.
    Vec3 position_mm = Vec3::Zero(); // Position of the plant's origin, world frame.
    double rotation_rad = 0;         // Rotation about the world's +z, counter-clockwise from above.

    MeshSource mesh = static_cast<mesh::Mesh const*>(nullptr);

    // Coarser levels of detail, finest first, which replace `mesh` if the plant covers less than
    // `min_coverage` (0 to 1) of the screen's area. In .glb files only.
    std::vector<DetailLevel> details {};
    double min_coverage = 0;
};

// Returns the triangles of `source`: its mesh if it has one, otherwise the value of `made`. If
// `made` has no value, the triangles are made and stored there. The mesh of a billboard has no
// picture.
mesh::Mesh const& mesh_of(MeshSource const& source, std::optional<mesh::Mesh>& made);

} // namespace tractus::exports
