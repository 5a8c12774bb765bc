#include "engine/export/gltf_scene.h"

#include "engine/export/compressed_views.h"
#include "engine/export/glb_accessor.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/core.h>
#include <utility>

namespace tractus::exports {

namespace {

// Maximum number of uses of all meshes together, by nodes and instances.
constexpr std::size_t kMaxPlaces = std::size_t { 1 } << 24;
constexpr int kDeepestJson = 64;
constexpr std::string_view kInstancing = "EXT_mesh_gpu_instancing";

std::uint32_t u32_at(std::string_view bytes, std::size_t offset)
{
    std::uint32_t value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

// True if the JSON is nested too deeply to be parsed: the parser is recursive.
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

Result<void> load_json(std::string_view bytes, tinygltf::Model& model)
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

// Fails if the file requires an unknown extension, unless the extension only changes the
// appearance.
Result<void> check_extensions(tinygltf::Model const& model)
{
    for (auto const& name : model.extensionsRequired) {
        bool const known = name == kInstancing || name == "KHR_mesh_quantization"
            || name == "EXT_meshopt_compression" || name == "KHR_texture_transform"
            || name == "KHR_lights_punctual" || name.starts_with("KHR_materials_");
        if (!known)
            return fail_reading(
                fmt::format("it needs the extension {}, which is not supported", name));
    }
    return {};
}

// Collects, for each mesh, the transforms of all its uses to the scene's frame.
class PlaceCollector {
public:
    explicit PlaceCollector(tinygltf::Model const& model)
        : model_(model)
        , seen_(model.nodes.size())
        , of_mesh_(model.meshes.size())
    {
    }

    // Visits the nodes of the default scene, or, if the file has no scenes, all nodes.
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

    std::vector<std::vector<Affine>> take() { return std::move(of_mesh_); }

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
        if (count_ > kMaxPlaces)
            return fail_reading(fmt::format("it has more than {} instances", kMaxPlaces));
        return {};
    }

    // Reads an attribute of EXT_mesh_gpu_instancing, which has one element per instance. The result
    // is empty if there is no attribute of that name.
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
        if (count_ > kMaxPlaces)
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

} // namespace

tl::unexpected<Error> fail_reading(std::string const& reason)
{
    return fail(Fault::User, "cannot read the glTF file: " + reason);
}

Result<tinygltf::Model> parse_glb(std::string_view bytes)
{
    TRY(check_header(bytes));
    tinygltf::Model model;
    auto const compressed = TRY(find_compressed_views(bytes));
    TRY(load_json(compressed.views.empty() ? bytes : compressed.glb, model));
    TRY(check_extensions(model));
    TRY(decompress_views(compressed.views, model));
    return model;
}

Result<std::vector<std::vector<Affine>>> find_places(tinygltf::Model const& model)
{
    PlaceCollector places(model);
    TRY(places.collect());
    return places.take();
}

int accessor_of(tinygltf::Primitive const& primitive, char const* name)
{
    auto const found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

} // namespace tractus::exports
