#include "app/python/mesh_classes.h"

#include "app/python/arrays.h"
#include "app/python/errors.h"
#include "engine/export/gltf_material.h"
#include "engine/mesh/make_mesh.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <pybind11/stl.h>
#include <string>
#include <utility>
#include <vector>

namespace tractus::python {

namespace {

namespace py = pybind11;
using mesh::InstancedMesh;
using mesh::InstanceTransform;
using mesh::TriangleMesh;

// Triangles of a mesh, which they keep alive.
struct SurfaceHandle {
    std::shared_ptr<mesh::Mesh const> mesh;
    TriangleMesh const* triangles;
};

// All copies of one organ shape in a mesh.
struct OrgansHandle {
    std::shared_ptr<mesh::Mesh const> mesh;
    InstancedMesh const* organs;
};

std::vector<SurfaceHandle> surfaces_of(MeshHandle const& handle)
{
    std::vector<SurfaceHandle> surfaces;
    for (auto const& surface : handle.mesh->surfaces)
        surfaces.push_back({ handle.mesh, &surface });
    return surfaces;
}

std::vector<OrgansHandle> organs_of(MeshHandle const& handle)
{
    std::vector<OrgansHandle> all;
    for (auto const& organs : handle.mesh->organs)
        all.push_back({ handle.mesh, &organs });
    return all;
}

// Shows vectors of floats as rows.
template<typename Vectors> py::array show_rows(SurfaceHandle const& handle, Vectors const& vectors)
{
    constexpr int kWidth = Vectors::value_type::RowsAtCompileTime;
    static_assert(sizeof(typename Vectors::value_type) == kWidth * sizeof(float));
    return show_array(handle.mesh, vectors.empty() ? nullptr : vectors.front().data(),
                      { extent(vectors.size()), kWidth });
}

// Shows a member of each transform, `width` floats that begin at `first`.
py::array show_of_copies(OrgansHandle const& handle,
                         float const& (*first)(InstanceTransform const&), py::ssize_t width)
{
    auto const& copies = handle.organs->instances;
    static InstanceTransform const none {};
    return show_array(handle.mesh, &first(copies.empty() ? none : copies.front()),
                      { extent(copies.size()), width },
                      { extent(sizeof(InstanceTransform)), extent(sizeof(float)) });
}

void add_material(py::module_& module)
{
    py::class_<Material>(module, "Material", "The look of a surface, as in glTF.")
        .def_readonly("name", &Material::name)
        .def_property_readonly(
            "kind",
            [](Material const& material) {
                return std::string(exports::material_kind_name(material.kind));
            },
            "bark, stem, leaf, petal or solid.")
        .def_property_readonly(
            "base_color",
            [](Material const& material) {
                auto const& color = material.base_color;
                return std::array { color.x(), color.y(), color.z() };
            },
            "Red, green and blue, sRGB, 0 to 1.")
        .def_readonly("roughness", &Material::roughness, "0 to 1.")
        .def_readonly("translucency", &Material::translucency,
                      "The share of light that passes through, 0 to 1.");
}

void add_surface(py::module_& module)
{
    py::class_<SurfaceHandle>(module, "Surface", "Triangles of one material.")
        .def_property_readonly(
            "material", [](SurfaceHandle const& surface) { return surface.triangles->material; },
            "An index into Mesh.materials.")
        .def_property_readonly(
            "positions_mm",
            [](SurfaceHandle const& surface) {
                return show_rows(surface, surface.triangles->positions_mm);
            },
            "(v, 3) float32. Not copied.")
        .def_property_readonly(
            "normals",
            [](SurfaceHandle const& surface) {
                return show_rows(surface, surface.triangles->normals);
            },
            "(v, 3) float32, of unit length. Not copied.")
        .def_property_readonly(
            "texture_coordinates",
            [](SurfaceHandle const& surface) {
                return show_rows(surface, surface.triangles->texture_coordinates);
            },
            "(v, 2) float32: u, v. Not copied.")
        .def_property_readonly(
            "indices",
            [](SurfaceHandle const& surface) {
                auto const& indices = surface.triangles->indices;
                return show_array(surface.mesh, indices.data(), { extent(indices.size() / 3), 3 });
            },
            "(t, 3) uint32: vertices of the triangles, counter-clockwise from outside. Not "
            "copied.");
}

void add_organs(py::module_& module)
{
    py::class_<OrgansHandle>(module, "Organs", R"(All copies of one shape of organ.

A copy is the prototype, scaled along its axes, then rotated, then moved.)")
        .def_property_readonly(
            "shape", [](OrgansHandle const& handle) { return handle.organs->shape; },
            "An index into Plant.organ_shapes.")
        .def_property_readonly(
            "prototype",
            [](OrgansHandle const& handle) {
                return SurfaceHandle { handle.mesh, &handle.organs->prototype };
            },
            "The triangles of one organ at scale 1, in its own frame.")
        .def_property_readonly(
            "translations_mm",
            [](OrgansHandle const& handle) {
                return show_of_copies(
                    handle,
                    [](InstanceTransform const& copy) -> float const& {
                        return copy.translation_mm.x();
                    },
                    3);
            },
            "(n, 3) float32. Not copied.")
        .def_property_readonly(
            "rotations",
            [](OrgansHandle const& handle) {
                return show_of_copies(
                    handle,
                    [](InstanceTransform const& copy) -> float const& {
                        return copy.rotation.coeffs().x();
                    },
                    4);
            },
            "(n, 4) float32: unit quaternions x, y, z, w. Not copied.")
        .def_property_readonly(
            "scales",
            [](OrgansHandle const& handle) {
                return show_of_copies(
                    handle,
                    [](InstanceTransform const& copy) -> float const& { return copy.scale.x(); },
                    3);
            },
            "(n, 3) float32. Not copied.");
}

} // namespace

MeshHandle mesh_of_plant(PlantHandle const& plant, int sides, int subdivision)
{
    check_range("sides", sides, 3, 64);
    check_range("subdivision", subdivision, 0, 16);
    mesh::MeshOptions options;
    options.max_sides = sides;
    options.min_sides = std::min(options.min_sides, sides);
    options.subdivision = subdivision;
    return { without_gil([&] {
        return std::make_shared<mesh::Mesh const>(mesh::make_mesh(*plant.plant, options));
    }) };
}

void add_mesh_classes(py::module_& module)
{
    add_material(module);
    add_surface(module);
    add_organs(module);
    py::class_<MeshHandle>(module, "Mesh",
                           R"(A plant as triangles, in the plant's frame, millimetres.

Arrays are read-only, show the mesh's own memory and keep it alive.)")
        .def_property_readonly("materials",
                               [](MeshHandle const& handle) { return handle.mesh->materials; })
        .def_property_readonly("surfaces", &surfaces_of,
                               "Branches and polygons: one surface for each material.")
        .def_property_readonly("organs", &organs_of,
                               "Leaves, flowers and fruits: one entry for each shape of organ.")
        .def_property_readonly(
            "triangle_count",
            [](MeshHandle const& handle) { return handle.mesh->triangle_count(); },
            "The number of triangles, with those of every copy of an organ.")
        .def("__repr__", [](MeshHandle const& handle) {
            return fmt::format("<tractus.Mesh of {} triangles>", handle.mesh->triangle_count());
        });
}

} // namespace tractus::python
