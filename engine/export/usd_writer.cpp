#include "engine/export/usd_writer.h"

#include "engine/export/gltf_frame.h"
#include "engine/export/gltf_material.h"
#include "engine/export/usd_materials.h"
#include "engine/export/usd_text.h"
#include "engine/mesh/mesh_measures.h"
#include "engine/mesh/organ_copy.h"

#include <array>
#include <string>

namespace tractus::exports {

namespace {

constexpr char const* kPlants = "plants";

// Writes numbers as a tuple, with the seven digits that a float has.
template<typename Output> void write_tuple(Output to, Vec3f const& v)
{
    fmt::format_to(to, "({:.7g}, {:.7g}, {:.7g})", v.x(), v.y(), v.z());
}

// A prototype of organs, and the copies that use it.
struct UsdPrototype {
    mesh::TriangleMesh mesh;
    std::vector<mesh::InstanceTransform> instances; // Mirrored ones refer to a mirrored mesh.
};

// Returns the mesh, mirrored along x.
mesh::TriangleMesh mirrored(mesh::TriangleMesh const& mesh)
{
    mesh::TriangleMesh result = mesh;
    auto place = mesh::place_in(result, {});
    mesh::append_copy(mesh, { .scale = { -1, 1, 1 } }, place);
    return result;
}

// Returns the prototypes of an organ shape: one for its copies and one for those that are mirrored,
// as far as there are any.
std::vector<UsdPrototype> prototypes_of(mesh::InstancedMesh const& organ)
{
    UsdPrototype plain { organ.prototype, {} };
    UsdPrototype mirror { {}, {} };
    for (auto instance : organ.instances) {
        bool const is_mirrored = instance.scale.prod() < 0;
        if (is_mirrored)
            instance.scale.x() = -instance.scale.x();
        (is_mirrored ? mirror : plain).instances.push_back(instance);
    }
    if (!mirror.instances.empty())
        mirror.mesh = mirrored(organ.prototype);
    std::vector<UsdPrototype> found;
    for (auto* const prototype : { &plain, &mirror })
        if (!prototype->instances.empty())
            found.push_back(std::move(*prototype));
    return found;
}

// The instances of all prototypes of a plant, in glTF's frame, for the arrays of a PointInstancer.
struct UsdInstances {
    std::vector<std::size_t> prototypes;
    std::vector<mesh::InstanceTransform> transforms;
    Bounds bounds_m;

    UsdInstances(std::vector<UsdPrototype> const& all)
    {
        for (std::size_t i = 0; i < all.size(); ++i) {
            auto const box = mesh::bounds(all[i].mesh);
            for (auto const& instance : all[i].instances) {
                prototypes.push_back(i);
                transforms.push_back(to_gltf(instance));
                add_box(instance, box);
            }
        }
    }

    // Adds the corners of a prototype's box.
    void add_box(mesh::InstanceTransform const& instance, Bounds const& box)
    {
        for (int corner = 0; corner < 8; ++corner) {
            Vec3f at;
            for (int axis = 0; axis < 3; ++axis)
                at[axis] = static_cast<float>(
                    ((corner >> axis & 1) != 0 ? box.max_mm : box.min_mm)[axis]);
            bounds_m.add(to_gltf(Vec3(mesh::placed(instance, at).cast<double>())));
        }
    }
};

class UsdWriter {
public:
    UsdWriter(UsdText& text, UsdMaterials& materials, UsdOptions const& options)
        : text_(text)
        , materials_(materials)
        , options_(options)
    {
    }

    void add(PlacedMesh const& placed, std::string const& name)
    {
        std::optional<mesh::Mesh> made;
        auto const& mesh = mesh_of(placed.mesh, made);
        std::array const metadata { std::string("kind = \"component\"") };
        text_.begin("Xform", name, metadata);
        Vec3 const at = to_gltf(placed.position_mm);
        text_.line("double3 xformOp:translate = ({:.9g}, {:.9g}, {:.9g})", at.x(), at.y(), at.z());
        text_.line("double xformOp:rotateY = {:.9g}", degrees(placed.rotation_rad));
        text_.line("uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:rotateY\"]");
        UsdNames names;
        for (auto const& surface : mesh.surfaces)
            add_mesh(surface, mesh.materials, names);
        add_organs(mesh, names);
        text_.end();
    }

private:
    void add_mesh(mesh::TriangleMesh const& mesh, std::vector<Material> const& materials,
                  UsdNames& names)
    {
        auto const& material = materials[mesh.material];
        std::array const metadata { std::string("prepend apiSchemas = [\"MaterialBindingAPI\"]") };
        text_.begin("Mesh", names.unused(material.name), metadata);
        auto const box = mesh::bounds(mesh);
        if (!box.empty()) {
            Bounds turned;
            turned.add(to_gltf(box.min_mm));
            turned.add(to_gltf(box.max_mm));
            add_extent(turned);
        }
        text_.line("uniform bool doubleSided = {}", is_thin(material.kind) ? 1 : 0);
        text_.line("uniform token subdivisionScheme = \"none\"");
        text_.line("rel material:binding = <{}>", materials_.path_of(material));
        Vec3 const color = linear_color(material.base_color);
        text_.line("color3f[] primvars:displayColor = [({:.6g}, {:.6g}, {:.6g})]", color.x(),
                   color.y(), color.z());
        add_arrays(mesh);
        text_.end();
    }

    void add_arrays(mesh::TriangleMesh const& mesh)
    {
        text_.array("int[] faceVertexCounts", mesh.triangle_count(),
                    [](auto to, std::size_t) { fmt::format_to(to, "3"); });
        text_.array("int[] faceVertexIndices", mesh.indices.size(),
                    [&](auto to, std::size_t i) { fmt::format_to(to, "{}", mesh.indices[i]); });
        text_.array("point3f[] points", mesh.positions_mm.size(), [&](auto to, std::size_t i) {
            write_tuple(to, to_gltf(mesh.positions_mm[i]));
        });
        text_.array(
            "normal3f[] normals", mesh.normals.size(),
            [&](auto to, std::size_t i) {
                Vec3f const n = turn_to_gltf(mesh.normals[i]);
                fmt::format_to(to, "({:.4f}, {:.4f}, {:.4f})", n.x(), n.y(), n.z());
            },
            "vertex");
        // The first row of a picture is at v = 0, but at t = 1 in USD.
        text_.array(
            "texCoord2f[] primvars:st", mesh.texture_coordinates.size(),
            [&](auto to, std::size_t i) {
                auto const& uv = mesh.texture_coordinates[i];
                fmt::format_to(to, "({:.6g}, {:.6g})", uv.x(), 1 - uv.y());
            },
            "vertex");
    }

    void add_extent(Bounds const& box)
    {
        text_.array("float3[] extent", 2, [&](auto to, std::size_t i) {
            write_tuple(to, Vec3f((i == 0 ? box.min_mm : box.max_mm).cast<float>()));
        });
    }

    void add_organs(mesh::Mesh const& mesh, UsdNames& names)
    {
        if (options_.organs == UsdOptions::Organs::Merged) {
            for (auto const& organ : mesh.organs)
                add_mesh(mesh::merged_copies(organ), mesh.materials, names);
            return;
        }
        std::vector<UsdPrototype> prototypes;
        for (auto const& organ : mesh.organs)
            for (auto& prototype : prototypes_of(organ))
                prototypes.push_back(std::move(prototype));
        if (!prototypes.empty())
            add_instancer(prototypes, mesh.materials, names.unused("organs"));
    }

    // Writes the prototypes into a prim of their own and returns their paths.
    std::vector<std::string> add_prototypes(std::vector<UsdPrototype> const& prototypes,
                                            std::vector<Material> const& materials)
    {
        std::vector<std::string> paths;
        UsdNames names;
        text_.begin("Scope", "Prototypes");
        for (auto const& prototype : prototypes) {
            auto const own = names.unused(materials[prototype.mesh.material].name);
            paths.push_back(fmt::format("{}/{}", text_.path(), own));
            text_.begin("Xform", own);
            UsdNames inner;
            add_mesh(prototype.mesh, materials, inner);
            text_.end();
        }
        text_.end();
        return paths;
    }

    void add_instancer(std::vector<UsdPrototype> const& prototypes,
                       std::vector<Material> const& materials, std::string const& name)
    {
        text_.begin("PointInstancer", name);
        auto const path = text_.path();
        UsdInstances const instances(prototypes);
        auto const& all = instances.transforms;
        add_extent(instances.bounds_m);
        text_.array("int[] protoIndices", all.size(), [&](auto to, std::size_t i) {
            fmt::format_to(to, "{}", instances.prototypes[i]);
        });
        text_.array("point3f[] positions", all.size(),
                    [&](auto to, std::size_t i) { write_tuple(to, all[i].translation_mm); });
        auto const write_rotation = [&](auto to, std::size_t i) {
            auto const& q = all[i].rotation;
            fmt::format_to(to, "({:.7g}, {:.7g}, {:.7g}, {:.7g})", q.w(), q.x(), q.y(), q.z());
        };
        text_.array("quath[] orientations", all.size(), write_rotation);
        text_.array("quatf[] orientationsf", all.size(), write_rotation);
        text_.array("float3[] scales", all.size(),
                    [&](auto to, std::size_t i) { write_tuple(to, all[i].scale); });
        auto const paths = add_prototypes(prototypes, materials);
        text_.array("rel prototypes", paths.size(),
                    [&](auto to, std::size_t i) { fmt::format_to(to, "<{}>", paths[i]); });
        text_.end();
    }

    UsdText& text_;
    UsdMaterials& materials_;
    UsdOptions options_;
};

} // namespace

Result<std::vector<PictureFile>> write_usda(std::ostream& out, std::span<PlacedMesh const> plants,
                                            std::string_view stem, UsdOptions const& options)
{
    UsdText text(out, kPlants);
    UsdMaterials materials(fmt::format("/{}", kPlants), std::string(stem));
    std::array const metadata { std::string("kind = \"group\"") };
    text.begin("Xform", kPlants, metadata);
    UsdWriter writer(text, materials, options);
    UsdNames names;
    names.unused("Materials"); // The prim of that name.
    for (auto const& placed : plants)
        writer.add(placed, names.unused(placed.name));
    materials.write(text);
    text.end();
    text.flush();
    if (!out.flush())
        return fail(Fault::User,
                    "cannot write the USD file: the disk is full or the stream failed");
    return materials.take_pictures();
}

} // namespace tractus::exports
