#include "engine/export/glb_reader.h"

#include "engine/export/glb_accessor.h"
#include "engine/export/gltf_frame.h"
#include "engine/export/gltf_scene.h"
#include "engine/export/read_materials.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tractus::exports {
namespace {

// Maximum number of vertices in the mesh that is read; a prototype of instances counts once.
constexpr std::size_t kMaxVertices = std::size_t { 1 } << 26;

void compute_normals(mesh::TriangleMesh& mesh)
{
    mesh.normals.assign(mesh.positions_mm.size(), Vec3f::Zero());
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        auto const a = mesh.indices[i];
        auto const b = mesh.indices[i + 1];
        auto const c = mesh.indices[i + 2];
        Vec3f const area = (mesh.positions_mm[b] - mesh.positions_mm[a])
                               .cross(mesh.positions_mm[c] - mesh.positions_mm[a]);
        for (auto const corner : { a, b, c })
            mesh.normals[corner] += area;
    }
}

// Normalises normals. A normal that is zero or not finite becomes +z.
void normalize(std::span<Vec3f> normals)
{
    for (auto& normal : normals) {
        float const length = normal.norm();
        normal = length > 0 && std::isfinite(length) ? Vec3f(normal / length) : Vec3f::UnitZ();
    }
}

// Returns the triangles of a primitive, in our frame; no value if it consists of points or lines.
Result<std::optional<mesh::TriangleMesh>> read_primitive(tinygltf::Model const& model,
                                                         tinygltf::Primitive const& primitive)
{
    if (primitive.mode != -1 && primitive.mode != TINYGLTF_MODE_TRIANGLES) {
        if (primitive.mode > TINYGLTF_MODE_TRIANGLES)
            return fail_reading("it has triangle strips or fans, which are not supported");
        return std::optional<mesh::TriangleMesh>();
    }
    auto const accessor = [&](char const* name) { return accessor_of(primitive, name); };
    mesh::TriangleMesh mesh;
    for (auto const& position : TRY(read_accessor<3>(model, accessor("POSITION"))))
        mesh.positions_mm.push_back(from_gltf(Vec3f(position.data())));
    if (!std::all_of(mesh.positions_mm.begin(), mesh.positions_mm.end(),
                     [](Vec3f const& p) { return p.allFinite(); }))
        return fail_reading("a coordinate is not a finite number");
    auto const vertex_count = mesh.positions_mm.size();

    if (primitive.indices >= 0) {
        mesh.indices = TRY(read_indices(model, primitive.indices, vertex_count));
    } else {
        for (std::uint32_t i = 0; i < vertex_count; ++i)
            mesh.indices.push_back(i);
    }
    if (mesh.indices.size() % 3 != 0)
        return fail_reading("a mesh's last triangle is not whole");

    if (accessor("NORMAL") >= 0)
        for (auto const& normal : TRY(read_accessor<3>(model, accessor("NORMAL"))))
            mesh.normals.push_back(turn_from_gltf(Vec3f(normal.data())));
    else
        compute_normals(mesh);
    normalize(mesh.normals);
    if (accessor("TEXCOORD_0") >= 0)
        for (auto const& texture : TRY(read_accessor<2>(model, accessor("TEXCOORD_0"))))
            mesh.texture_coordinates.emplace_back(texture.data());
    else
        mesh.texture_coordinates.assign(vertex_count, Vec2f::Zero());
    if (mesh.normals.size() != vertex_count || mesh.texture_coordinates.size() != vertex_count)
        return fail_reading("a mesh's attributes have different counts");
    auto const place = primitive.material >= 0
            && static_cast<std::size_t>(primitive.material) < model.materials.size()
        ? texture_transform(model.materials[static_cast<std::size_t>(primitive.material)])
        : Eigen::Affine2f::Identity();
    for (auto& texture : mesh.texture_coordinates) {
        texture = place * texture;
        if (!texture.allFinite())
            texture.setZero();
    }
    return std::optional(std::move(mesh));
}

// Decomposes a transform, in glTF's frame, into scale, rotation and translation, in our frame.
// Returns no value if the transform shears, flattens or has numbers that are too large.
std::optional<mesh::InstanceTransform> instance_of(Affine const& place)
{
    Eigen::Matrix3d axes = place.linear();
    Vec3 scale = axes.colwise().norm();
    if (!(scale.minCoeff() > 1e-9))
        return std::nullopt;
    if (axes.determinant() < 0)
        scale.x() = -scale.x();
    for (Eigen::Index i = 0; i < 3; ++i)
        axes.col(i) /= scale[i];
    if (!(axes.transpose() * axes).isApprox(Eigen::Matrix3d::Identity(), 1e-4))
        return std::nullopt;
    auto const instance = from_gltf(mesh::InstanceTransform { place.translation().cast<float>(),
                                                              Quat(axes).normalized().cast<float>(),
                                                              scale.cast<float>() });
    if (!instance.translation_mm.allFinite() || !instance.scale.allFinite())
        return std::nullopt;
    return instance;
}

// Assembles the mesh of a file: one surface per material, and instances by prototype.
class Builder {
public:
    explicit Builder(tinygltf::Model const& model)
        : model_(model)
    {
        mesh_.materials = read_materials(model);
    }

    Result<mesh::Mesh> build(std::vector<std::vector<Affine>> const& places)
    {
        if (mesh_.materials.size() >= std::numeric_limits<MaterialId>::max())
            return fail_reading("it has too many materials");
        for (std::size_t i = 0; i < model_.meshes.size(); ++i) {
            if (places[i].empty())
                continue;
            for (auto const& primitive : model_.meshes[i].primitives)
                TRY(add(primitive, places[i]));
        }
        for (auto& [material, surface] : surfaces_)
            mesh_.surfaces.push_back(std::move(surface));
        return std::move(mesh_);
    }

private:
    Result<void> add(tinygltf::Primitive const& primitive, std::vector<Affine> const& places)
    {
        auto read = TRY(read_primitive(model_, primitive));
        if (!read || read->indices.empty())
            return {};
        read->material = TRY(material_index(primitive.material));
        vertices_ += read->positions_mm.size();
        if (places.size() > 1 && add_instances(*read, places))
            return vertices_ > kMaxVertices ? too_large() : Result<void>();
        vertices_ += read->positions_mm.size() * (places.size() - 1);
        if (vertices_ > kMaxVertices)
            return too_large();
        for (auto const& place : places)
            append(*read, place);
        auto const& positions = surfaces_[read->material].positions_mm;
        if (!std::all_of(
                positions.end()
                    - static_cast<std::ptrdiff_t>(read->positions_mm.size() * places.size()),
                positions.end(), [](Vec3f const& p) { return p.allFinite(); }))
            return fail_reading("a transform takes a mesh beyond what numbers can hold");
        return {};
    }

    static Result<void> too_large()
    {
        return fail_reading(fmt::format("it expands to more than {} vertices", kMaxVertices));
    }

    Result<MaterialId> material_index(int index)
    {
        if (index >= 0 && static_cast<std::size_t>(index) < model_.materials.size())
            return static_cast<MaterialId>(index);
        if (index >= 0)
            return fail_reading(fmt::format("material {} does not exist", index));
        if (mesh_.materials.size() == model_.materials.size())
            mesh_.materials.push_back({ .name = "default",
                                        .kind = Material::Kind::Solid,
                                        .base_color { 0.8f, 0.8f, 0.8f } });
        return static_cast<MaterialId>(model_.materials.size());
    }

    bool add_instances(mesh::TriangleMesh& prototype, std::vector<Affine> const& places)
    {
        mesh::InstancedMesh organ;
        organ.instances.reserve(places.size());
        for (auto const& place : places) {
            auto const instance = instance_of(place);
            if (!instance)
                return false;
            organ.instances.push_back(*instance);
        }
        organ.prototype = std::move(prototype);
        mesh_.organs.push_back(std::move(organ));
        return true;
    }

    void append(mesh::TriangleMesh const& part, Affine const& place)
    {
        auto& surface = surfaces_[part.material];
        surface.material = part.material;
        auto const base = static_cast<std::uint32_t>(surface.positions_mm.size());
        Eigen::Matrix3d const linear = place.linear();
        // Normals are transformed by the cofactors of `linear`, and flipped below if the transform
        // mirrors.
        Eigen::Matrix3d cofactors;
        cofactors << linear.col(1).cross(linear.col(2)), linear.col(2).cross(linear.col(0)),
            linear.col(0).cross(linear.col(1));
        bool const mirrored = linear.determinant() < 0;
        for (std::size_t i = 0; i < part.positions_mm.size(); ++i) {
            Vec3 const position = place * to_gltf(Vec3(part.positions_mm[i].cast<double>()));
            Vec3 const normal = cofactors * turn_to_gltf(Vec3(part.normals[i].cast<double>()));
            surface.positions_mm.push_back(from_gltf(position).cast<float>());
            surface.normals.push_back(
                turn_from_gltf(Vec3(mirrored ? -normal : normal)).cast<float>());
        }
        normalize(std::span(surface.normals).subspan(base));
        surface.texture_coordinates.insert(surface.texture_coordinates.end(),
                                           part.texture_coordinates.begin(),
                                           part.texture_coordinates.end());
        for (std::size_t i = 0; i < part.indices.size(); i += 3) {
            surface.indices.push_back(base + part.indices[i]);
            surface.indices.push_back(base + part.indices[i + (mirrored ? 2 : 1)]);
            surface.indices.push_back(base + part.indices[i + (mirrored ? 1 : 2)]);
        }
    }

    tinygltf::Model const& model_;
    mesh::Mesh mesh_;
    std::map<MaterialId, mesh::TriangleMesh> surfaces_;
    std::size_t vertices_ = 0;
};

} // namespace

Result<mesh::Mesh> read_glb(std::string_view bytes)
{
    auto const model = TRY(parse_glb(bytes));
    return Builder(model).build(TRY(find_places(model)));
}

} // namespace tractus::exports
