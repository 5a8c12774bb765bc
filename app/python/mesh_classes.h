#pragma once

#include "app/python/plant_class.h"
#include "engine/mesh/mesh.h"

#include <cstddef>
#include <memory>
#include <pybind11/pybind11.h>

namespace tractus::python {

// A mesh as Python holds it. Its arrays share the mesh.
struct MeshHandle {
    std::shared_ptr<mesh::Mesh const> mesh;
};

// Returns the mesh of a plant. `sides` and `subdivision` are mesh::MeshOptions::max_sides and
// subdivision. Throws Failure if one of them is out of range.
MeshHandle mesh_of_plant(PlantHandle const& plant, int sides, int subdivision);

// Adds Mesh, Surface, Organs and Material to the module.
void add_mesh_classes(pybind11::module_& module);

} // namespace tractus::python
