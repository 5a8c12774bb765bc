#include "engine/export/glb_reader.h"

#include "engine/export/glb_accessor.h"
#include "engine/export/gltf_frame.h"
#include "engine/export/gltf_material.h"
#include "engine/export/tinygltf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fmt/core.h>
#include <limits>
#include <map>
#include <optional>
#include <span>

namespace tractus {
namespace {

constexpr std::size_t kMostPlaces = std::size_t { 1 } << 24;   // Of all meshes together.
constexpr std::size_t kMostVertices = std::size_t { 1 } << 26; // After expanding.
constexpr int kDeepestJson = 64;
constexpr std::string_view kInstancing = "EXT_mesh_gpu_instancing";

using Affine = Eigen::Affine3d;

auto fail_reading(std::string const& reason)
{
    return fail(Fault::User, "cannot read the glTF file: " + reason);
}

std::uint32_t u32_at(std::string_view bytes, std::size_t offset)
{
    std::uint32_t value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

// The parser calls itself for each level, so the levels are counted before.
bool is_too_deep(std::string_view json)
{
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        char const c = json[i];
        if (in_string && c == '\\')
            ++i;
        else if (c == '"')
            in_string = !in_string;
        else if (!in_string && (c == '{' || c == '['))
            ++depth;
        else if (!in_string && (c == '}' || c == ']'))
            --depth;
        if (depth > kDeepestJson)
            return true;
    }
    return false;
}

Result<void> check_header(std::string_view bytes)
{
    if (bytes.size() < 4 || bytes.substr(0, 4) != "glTF")
        return fail_reading("it is not a binary glTF file (.glb)");
    if (bytes.size() < 20)
        return fail_reading("it is truncated within its header");
    if (u32_at(bytes, 4) != 2)
        return fail_reading(
            fmt::format("it has version {} and this reader knows version 2", u32_at(bytes, 4)));
    if (u32_at(bytes, 8) > bytes.size())
        return fail_reading(
            fmt::format("it is truncated: {} bytes of {}", bytes.size(), u32_at(bytes, 8)));
    if (u32_at(bytes, 12) > bytes.size() - 20)
        return fail_reading("its JSON part is truncated");
    if (is_too_deep(bytes.substr(20, u32_at(bytes, 12))))
        return fail_reading("its JSON part is nested too deeply");
    return {};
}

Result<void> load_model(std::string_view bytes, tinygltf::Model& model)
{
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int,
                             unsigned char const*, int, void*) { return true; },
                          nullptr);
    std::string error;
    std::string warning;
    try {
        auto const* const data = reinterpret_cast<unsigned char const*>(bytes.data());
        if (!loader.LoadBinaryFromMemory(&model, &error, &warning, data,
                                         static_cast<unsigned>(bytes.size()), "",
                                         tinygltf::REQUIRE_VERSION)) {
            error.erase(std::find(error.begin(), error.end(), '\n'), error.end());
            return fail_reading(error.empty() ? "its JSON part is not valid" : error);
        }
    } catch (std::exception const& exception) {
        return fail_reading(exception.what());
    }
    return {};
}

// What changes only looks may be ignored.
Result<void> check_extensions(tinygltf::Model const& model)
{
    for (auto const& name : model.extensionsRequired) {
        bool const known = name == kInstancing || name == "KHR_mesh_quantization"
            || name == "KHR_texture_transform" || name == "KHR_lights_punctual"
            || name.starts_with("KHR_materials_");
        if (!known)
            return fail_reading(
                fmt::format("it needs the extension {}, which is not supported", name));
    }
    return {};
}

Material material_of(tinygltf::Material const& from)
{
    Material material;
    material.name = from.name;
    auto const& surface = from.pbrMetallicRoughness;
    for (std::size_t i = 0; i < 3 && i < surface.baseColorFactor.size(); ++i)
        material.base_color[static_cast<Eigen::Index>(i)] = static_cast<float>(
            srgb_from_linear(std::clamp(surface.baseColorFactor[i], 0.0, 1.0)));
    material.roughness = static_cast<float>(std::clamp(surface.roughnessFactor, 0.0, 1.0));
    material.kind = from.doubleSided ? Material::Kind::Leaf : Material::Kind::Solid;
    if (!from.extras.IsObject())
        return material;
    if (auto const& kind = from.extras.Get("kind"); kind.IsString())
        material.kind = kind_of_word(kind.Get<std::string>()).value_or(material.kind);
    if (auto const& share = from.extras.Get("translucency"); share.IsNumber())
        material.translucency = static_cast<float>(std::clamp(share.GetNumberAsDouble(), 0.0, 1.0));
    return material;
}

// Where glTF's meshes stand: all their transforms to the scene's frame.
class Places {
public:
    explicit Places(tinygltf::Model const& model)
        : model_(model)
        , seen_(model.nodes.size())
        , of_mesh_(model.meshes.size())
    {
    }

    // The default scene; without scenes, every node that is nobody's child.
    Result<void> collect()
    {
        for (auto const node : roots())
            pending_.push_back({ node, Affine::Identity() });
        while (!pending_.empty()) {
            auto const [node, parent] = pending_.back();
            pending_.pop_back();
            TRY(visit(node, parent));
        }
        return {};
    }

    std::vector<Affine> const& of_mesh(std::size_t mesh) const { return of_mesh_[mesh]; }

private:
    struct Pending {
        int node;
        Affine parent;
    };

    std::vector<int> roots() const
    {
        if (!model_.scenes.empty()) {
            auto const wanted = static_cast<std::size_t>(std::max(0, model_.defaultScene));
            return model_.scenes[wanted < model_.scenes.size() ? wanted : 0].nodes;
        }
        std::vector<bool> is_child(model_.nodes.size());
        for (auto const& node : model_.nodes)
            for (auto const child : node.children)
                if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
                    is_child[static_cast<std::size_t>(child)] = true;
        std::vector<int> found;
        for (std::size_t i = 0; i < is_child.size(); ++i)
            if (!is_child[i])
                found.push_back(static_cast<int>(i));
        return found;
    }

    Result<void> visit(int index, Affine const& parent)
    {
        if (index < 0 || static_cast<std::size_t>(index) >= model_.nodes.size())
            return fail_reading(fmt::format("node {} does not exist", index));
        if (seen_[static_cast<std::size_t>(index)])
            return fail_reading(fmt::format("node {} has two parents", index));
        seen_[static_cast<std::size_t>(index)] = true;
        auto const& node = model_.nodes[static_cast<std::size_t>(index)];
        Affine const here = parent * local_transform(node);
        if (!here.matrix().allFinite())
            return fail_reading(fmt::format("node {}'s transform is not finite", index));
        if (node.mesh >= 0)
            TRY(add_mesh(node, here));
        for (auto const child : node.children)
            pending_.push_back({ child, here });
        return {};
    }

    static Affine local_transform(tinygltf::Node const& node)
    {
        Affine local = Affine::Identity();
        if (node.matrix.size() == 16) {
            local.matrix() = Eigen::Map<Eigen::Matrix4d const>(node.matrix.data());
            local.makeAffine();
            return local;
        }
        if (auto const& t = node.translation; t.size() == 3)
            local.translate(Vec3(t[0], t[1], t[2]));
        if (auto const& r = node.rotation; r.size() == 4)
            local.rotate(Quat(r[3], r[0], r[1], r[2]).normalized());
        if (auto const& s = node.scale; s.size() == 3)
            local.scale(Vec3(s[0], s[1], s[2]));
        return local;
    }

    Result<void> add_mesh(tinygltf::Node const& node, Affine const& here)
    {
        if (static_cast<std::size_t>(node.mesh) >= of_mesh_.size())
            return fail_reading(fmt::format("mesh {} does not exist", node.mesh));
        auto& places = of_mesh_[static_cast<std::size_t>(node.mesh)];
        auto const extension = node.extensions.find(std::string(kInstancing));
        if (extension == node.extensions.end()) {
            places.push_back(here);
            ++count_;
        } else {
            TRY(add_instances(extension->second, here, places));
        }
        if (count_ > kMostPlaces)
            return fail_reading(fmt::format("it has more than {} instances", kMostPlaces));
        return {};
    }

    // An accessor of the extension's attributes. No value if it does not have that one.
    template<std::size_t Components>
    Result<std::vector<std::array<float, Components>>> attribute(tinygltf::Value const& extension,
                                                                 char const* name)
    {
        using Values = std::vector<std::array<float, Components>>;
        if (!extension.IsObject() || !extension.Get("attributes").IsObject())
            return Values();
        auto const& attributes = extension.Get("attributes");
        if (!attributes.Has(name) || !attributes.Get(name).IsInt())
            return Values();
        return read_accessor<Components>(model_, attributes.Get(name).GetNumberAsInt());
    }

    Result<void> add_instances(tinygltf::Value const& extension, Affine const& here,
                               std::vector<Affine>& places)
    {
        auto const translations = TRY(attribute<3>(extension, "TRANSLATION"));
        auto const rotations = TRY(attribute<4>(extension, "ROTATION"));
        auto const scales = TRY(attribute<3>(extension, "SCALE"));
        auto const count = std::max({ translations.size(), rotations.size(), scales.size() });
        count_ += count;
        if (count_ > kMostPlaces)
            return {};
        for (auto const size : { translations.size(), rotations.size(), scales.size() })
            if (size != 0 && size != count)
                return fail_reading("an instanced mesh's attributes have different counts");
        for (std::size_t i = 0; i < count; ++i) {
            Affine place = here;
            if (!translations.empty())
                place.translate(Eigen::Map<Vec3f const>(translations[i].data()).cast<double>());
            if (!rotations.empty())
                place.rotate(Quatf(rotations[i].data()).cast<double>().normalized());
            if (!scales.empty())
                place.scale(Eigen::Map<Vec3f const>(scales[i].data()).cast<double>());
            if (!place.matrix().allFinite())
                return fail_reading("an instance's transform is not finite");
            places.push_back(place);
        }
        return {};
    }

    tinygltf::Model const& model_;
    std::vector<bool> seen_;
    std::vector<Pending> pending_;
    std::vector<std::vector<Affine>> of_mesh_;
    std::size_t count_ = 0;
};

void compute_normals(TriangleMesh& mesh)
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

// A normal without direction points up.
void normalize(std::span<Vec3f> normals)
{
    for (auto& normal : normals) {
        float const length = normal.norm();
        normal = length > 0 && std::isfinite(length) ? Vec3f(normal / length) : Vec3f::UnitZ();
    }
}

// The triangles of a primitive, in our frame. No value for points and lines.
Result<std::optional<TriangleMesh>> read_primitive(tinygltf::Model const& model,
                                                   tinygltf::Primitive const& primitive)
{
    if (primitive.mode != -1 && primitive.mode != TINYGLTF_MODE_TRIANGLES) {
        if (primitive.mode > TINYGLTF_MODE_TRIANGLES)
            return fail_reading("it has triangle strips or fans, which are not supported");
        return std::optional<TriangleMesh>();
    }
    auto const accessor = [&](char const* name) {
        auto const found = primitive.attributes.find(name);
        return found == primitive.attributes.end() ? -1 : found->second;
    };
    TriangleMesh mesh;
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
    for (auto& texture : mesh.texture_coordinates)
        if (!texture.allFinite())
            texture.setZero();
    return std::optional(std::move(mesh));
}

// A transform as scale, rotation and translation. No value if it shears, flattens or is too large.
std::optional<InstanceTransform> instance_of(Affine const& place)
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
    auto const instance = from_gltf(InstanceTransform { place.translation().cast<float>(),
                                                        Quat(axes).normalized().cast<float>(),
                                                        scale.cast<float>() });
    if (!instance.translation_mm.allFinite() || !instance.scale.allFinite())
        return std::nullopt;
    return instance;
}

// Puts what was read together: surfaces by material, instances by prototype.
class Builder {
public:
    explicit Builder(tinygltf::Model const& model)
        : model_(model)
    {
        for (auto const& material : model.materials)
            mesh_.materials.push_back(material_of(material));
    }

    Result<Mesh> build(Places const& places)
    {
        if (mesh_.materials.size() >= std::numeric_limits<MaterialId>::max())
            return fail_reading("it has too many materials");
        for (std::size_t i = 0; i < model_.meshes.size(); ++i) {
            if (places.of_mesh(i).empty())
                continue;
            for (auto const& primitive : model_.meshes[i].primitives)
                TRY(add(primitive, places.of_mesh(i)));
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
            return vertices_ > kMostVertices ? too_large() : Result<void>();
        vertices_ += read->positions_mm.size() * (places.size() - 1);
        if (vertices_ > kMostVertices)
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
        return fail_reading(fmt::format("it expands to more than {} vertices", kMostVertices));
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

    bool add_instances(TriangleMesh& prototype, std::vector<Affine> const& places)
    {
        InstancedMesh organ;
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

    void append(TriangleMesh const& part, Affine const& place)
    {
        auto& surface = surfaces_[part.material];
        surface.material = part.material;
        auto const base = static_cast<std::uint32_t>(surface.positions_mm.size());
        Eigen::Matrix3d const linear = place.linear();
        // Takes normals along, and flips them where the transform mirrors.
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
    Mesh mesh_;
    std::map<MaterialId, TriangleMesh> surfaces_;
    std::size_t vertices_ = 0;
};

} // namespace

Result<Mesh> read_glb(std::string_view bytes)
{
    TRY(check_header(bytes));
    tinygltf::Model model;
    TRY(load_model(bytes, model));
    TRY(check_extensions(model));
    Places places(model);
    TRY(places.collect());
    return Builder(model).build(places);
}

} // namespace tractus
