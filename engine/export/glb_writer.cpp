#include "engine/export/glb_writer.h"

#include "engine/export/gltf_frame.h"
#include "engine/export/gltf_material.h"
#include "engine/export/texture.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

namespace tractus {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

// glTF 2.0 sections 3.6.2.2, 3.6.2.4, 3.8.4 and 4.4.
constexpr std::uint32_t kMagic = 0x46546C67;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::uint64_t kMaxBytes = 0xFFFFFFFF;
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kNoTarget = 0;
constexpr int kRepeat = 10497;
constexpr int kClampToEdge = 33071;

constexpr std::size_t kElementsAtOnce = 4096; // Converted and written together.
constexpr std::size_t kFileHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

bool is_thin(Material::Kind kind)
{
    return kind == Material::Kind::Leaf || kind == Material::Kind::Petal;
}

std::string quoted(std::string const& text)
{
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

auto fail_writing()
{
    return fail(Fault::User, "cannot write the glTF file: the disk is full or the stream failed");
}

auto fail_infinite(char const* what)
{
    return fail(Fault::Station,
                fmt::format("cannot write the glTF file: {} is not a finite number", what));
}

// A JSON array that grows.
class JsonArray {
public:
    // Answers the new element's index.
    std::size_t add(std::string const& element)
    {
        if (count_ > 0)
            text_ += ',';
        text_ += element;
        return count_++;
    }
    std::size_t count() const { return count_; }
    std::string const& text() const { return text_; }

private:
    std::string text_;
    std::size_t count_ = 0;
};

// One try at a file, with a given room for its JSON.
class GlbFile {
public:
    GlbFile(std::ostream& out, GlbOptions const& options, std::uint64_t json_room)
        : out_(out)
        , options_(options)
        , json_room_(json_room)
        , start_(out.tellp())
    {
        out_ << std::string(kFileHeaderBytes + kChunkHeaderBytes, '\0');
        std::string const spaces(std::size_t { 1 } << 16, ' ');
        for (std::uint64_t left = json_room_; left > 0;) {
            auto const count = std::min<std::uint64_t>(left, spaces.size());
            out_.write(spaces.data(), static_cast<std::streamsize>(count));
            left -= count;
        }
    }

    Result<void> add(PlacedMesh const& placed, Mesh const& mesh)
    {
        if (file_bytes() + glb_bytes(mesh) > kMaxBytes)
            return fail(Fault::User,
                        fmt::format("plant {} would make the glTF file larger than 4 GiB: "
                                    "write fewer plants to a file",
                                    quoted(placed.name)));
        if (!placed.position_mm.allFinite() || !std::isfinite(placed.rotation_rad))
            return fail_infinite("a plant's place");
        std::string node = "{\"name\":" + quoted(placed.name) + placement(placed);
        if (auto const index = TRY(add_surfaces(placed.name, mesh)))
            node += fmt::format(",\"mesh\":{}", *index);
        std::string children;
        for (auto const& organ : mesh.organs)
            TRY(add_organ(organ, mesh, children));
        if (!children.empty())
            node += ",\"children\":[" + children + "]";
        scene_.add(fmt::format("{}", nodes_.add(node + "}")));
        if (!out_)
            return fail_writing();
        summary_.triangles += mesh.triangle_count();
        return {};
    }

    // Fills in headers and JSON. No value if the JSON does not fit in its room: then
    // `json_bytes()` says how much it takes.
    Result<std::optional<GlbSummary>> finish()
    {
        auto text = json();
        json_bytes_ = text.size();
        if (text.size() > json_room_)
            return std::optional<GlbSummary>();
        summary_.bytes = file_bytes();
        if (summary_.bytes > kMaxBytes)
            return fail(Fault::User,
                        "the glTF file would be larger than 4 GiB: write fewer plants to a file");
        auto const end = out_.tellp();
        out_.seekp(start_);
        put_u32({ kMagic, 2, static_cast<std::uint32_t>(summary_.bytes),
                  static_cast<std::uint32_t>(json_room_), kJsonChunk });
        out_ << text;
        if (binary_bytes_ > 0) {
            out_.seekp(
                start_
                + static_cast<std::streamoff>(kFileHeaderBytes + kChunkHeaderBytes + json_room_));
            put_u32({ static_cast<std::uint32_t>(binary_bytes_), kBinaryChunk });
        }
        out_.seekp(end);
        out_.flush();
        if (!out_)
            return fail_writing();
        return std::optional(summary_);
    }

    std::uint64_t json_bytes() const { return json_bytes_; }

private:
    std::uint64_t file_bytes() const
    {
        return kFileHeaderBytes + kChunkHeaderBytes + json_room_
            + (binary_bytes_ > 0 ? kChunkHeaderBytes + binary_bytes_ : 0);
    }

    void put_u32(std::initializer_list<std::uint32_t> values)
    {
        for (auto const value : values)
            out_.write(reinterpret_cast<char const*>(&value), sizeof value);
    }

    static std::string placement(PlacedMesh const& placed)
    {
        std::string text;
        if (!placed.position_mm.isZero(0)) {
            Vec3 const at = to_gltf(placed.position_mm);
            text += fmt::format(",\"translation\":[{},{},{}]", at.x(), at.y(), at.z());
        }
        if (placed.rotation_rad != 0)
            text += fmt::format(",\"rotation\":[0,{},0,{}]", std::sin(placed.rotation_rad / 2),
                                std::cos(placed.rotation_rad / 2));
        return text;
    }

    // The binary part.

    void put(void const* bytes, std::size_t size)
    {
        if (binary_bytes_ == 0)
            put_u32({ 0, 0 }); // The chunk's header, filled in by finish().
        out_.write(static_cast<char const*>(bytes), static_cast<std::streamsize>(size));
        binary_bytes_ += size;
    }

    // Ends a block that began at `start` and answers the index of a view of it.
    std::size_t add_view(std::uint64_t start, int target)
    {
        auto const size = binary_bytes_ - start;
        if (size % 4 != 0)
            put("\0\0\0", 4 - size % 4);
        std::string text
            = fmt::format("{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}", start, size);
        if (target != kNoTarget)
            text += fmt::format(",\"target\":{}", target);
        return views_.add(text + "}");
    }

    // Writes `count` elements of `Components` numbers each; `convert(i)` answers the i-th as a
    // std::array. Answers the index of an accessor.
    template<std::size_t Components, typename Number, typename Convert>
    std::size_t add_block(std::size_t count, int component_type, int target, Convert const& convert,
                          std::string const& more = {})
    {
        constexpr char const* kTypes[] = { "", "SCALAR", "VEC2", "VEC3", "VEC4" };
        auto const start = binary_bytes_;
        std::array<std::array<Number, Components>, kElementsAtOnce> block;
        for (std::size_t done = 0; done < count;) {
            auto const size = std::min(kElementsAtOnce, count - done);
            for (std::size_t i = 0; i < size; ++i)
                block[i] = convert(done + i);
            put(block.data(), size * sizeof block[0]);
            done += size;
        }
        auto const view = add_view(start, target);
        return accessors_.add(
            fmt::format("{{\"bufferView\":{},\"componentType\":{},\"count\":{},\"type\":\"{}\"{}}}",
                        view, component_type, count, kTypes[Components], more));
    }

    Result<std::size_t> add_positions(std::span<Vec3f const> positions_mm)
    {
        Vec3f low = to_gltf(positions_mm[0]);
        Vec3f high = low;
        for (auto const& position : positions_mm) {
            if (!position.allFinite())
                return fail_infinite("a coordinate");
            Vec3f const moved = to_gltf(position);
            low = low.cwiseMin(moved);
            high = high.cwiseMax(moved);
        }
        // As doubles: the decimal that is exactly the float.
        auto const limits = fmt::format(
            ",\"min\":[{},{},{}],\"max\":[{},{},{}]", double { low.x() }, double { low.y() },
            double { low.z() }, double { high.x() }, double { high.y() }, double { high.z() });
        return add_block<3, float>(
            positions_mm.size(), kFloat, kArrayBuffer,
            [&](std::size_t i) {
                Vec3f const moved = to_gltf(positions_mm[i]);
                return std::array { moved.x(), moved.y(), moved.z() };
            },
            limits);
    }

    std::size_t add_indices(TriangleMesh const& mesh)
    {
        auto const& indices = mesh.indices;
        // 65,535 is no index: it restarts strips (section 3.7.2.1).
        if (mesh.positions_mm.size() <= 65535)
            return add_block<1, std::uint16_t>(
                indices.size(), kUnsignedShort, kElementArrayBuffer, [&](std::size_t i) {
                    return std::array { static_cast<std::uint16_t>(indices[i]) };
                });
        return add_block<1, std::uint32_t>(
            indices.size(), kUnsignedInt, kElementArrayBuffer,
            [&](std::size_t i) { return std::array { indices[i] }; });
    }

    Result<std::string> add_primitive(TriangleMesh const& mesh, Material const& material)
    {
        auto const positions = TRY(add_positions(mesh.positions_mm));
        auto const normals
            = add_block<3, float>(mesh.normals.size(), kFloat, kArrayBuffer, [&](std::size_t i) {
                  Vec3f const turned = turn_to_gltf(mesh.normals[i]);
                  return std::array { turned.x(), turned.y(), turned.z() };
              });
        auto const texture = add_block<
            2, float>(mesh.texture_coordinates.size(), kFloat, kArrayBuffer, [&](std::size_t i) {
            return std::array { mesh.texture_coordinates[i].x(), mesh.texture_coordinates[i].y() };
        });
        auto const indices = add_indices(mesh);
        return fmt::format("{{\"attributes\":{{\"POSITION\":{},\"NORMAL\":{},\"TEXCOORD_0\":{}}},"
                           "\"indices\":{},\"material\":{}}}",
                           positions, normals, texture, indices, material_index(material));
    }

    // The plant's own mesh. No value if it has no tubes or polygons.
    Result<std::optional<std::size_t>> add_surfaces(std::string const& name, Mesh const& mesh)
    {
        JsonArray primitives;
        for (auto const& surface : mesh.surfaces)
            if (!surface.indices.empty())
                primitives.add(TRY(add_primitive(surface, mesh.materials[surface.material])));
        if (primitives.count() == 0)
            return std::optional<std::size_t>();
        return std::optional(meshes_.add(
            fmt::format("{{\"name\":{},\"primitives\":[{}]}}", quoted(name), primitives.text())));
    }

    // Organs.

    // Equal prototypes with equal materials are written once.
    Result<std::size_t> prototype_index(TriangleMesh const& prototype, Material const& material)
    {
        std::string key = fmt::format("{} ", material_index(material));
        auto const append = [&](auto const& values) {
            key.append(reinterpret_cast<char const*>(values.data()),
                       values.size() * sizeof values[0]);
        };
        append(prototype.positions_mm);
        append(prototype.normals);
        append(prototype.texture_coordinates);
        append(prototype.indices);
        if (auto const known = prototypes_.find(key); known != prototypes_.end())
            return known->second;
        auto const primitive = TRY(add_primitive(prototype, material));
        auto const index = meshes_.add(
            fmt::format("{{\"name\":{},\"primitives\":[{}]}}", quoted(material.name), primitive));
        prototypes_.emplace(std::move(key), index);
        return index;
    }

    Result<void> add_organ(InstancedMesh const& organ, Mesh const& mesh, std::string& children)
    {
        if (organ.instances.empty() || organ.prototype.indices.empty())
            return {};
        auto const finite = [](InstanceTransform const& instance) {
            return instance.translation_mm.allFinite() && instance.rotation.coeffs().allFinite()
                && instance.scale.allFinite();
        };
        if (!std::all_of(organ.instances.begin(), organ.instances.end(), finite))
            return fail_infinite("an organ's place");
        auto const index
            = TRY(prototype_index(organ.prototype, mesh.materials[organ.prototype.material]));
        auto const add_child = [&](std::string const& node) {
            children += fmt::format("{}{}", children.empty() ? "" : ",", nodes_.add(node));
        };
        if (options_.instancing == GlbOptions::Instancing::Extension) {
            add_child(instanced_node(index, organ.instances));
            return {};
        }
        for (auto const& instance : organ.instances) {
            auto const placed = to_gltf(instance);
            auto const& t = placed.translation_mm;
            auto const& r = placed.rotation;
            auto const& s = placed.scale;
            add_child(fmt::format(
                "{{\"mesh\":{},\"translation\":[{},{},{}],\"rotation\":[{},{},{},{}],"
                "\"scale\":[{},{},{}]}}",
                index, t.x(), t.y(), t.z(), r.x(), r.y(), r.z(), r.w(), s.x(), s.y(), s.z()));
        }
        return {};
    }

    std::string instanced_node(std::size_t mesh, std::vector<InstanceTransform> const& instances)
    {
        uses_instancing_ = true;
        auto const translations
            = add_block<3, float>(instances.size(), kFloat, kNoTarget, [&](std::size_t i) {
                  Vec3f const t = to_gltf(instances[i].translation_mm);
                  return std::array { t.x(), t.y(), t.z() };
              });
        auto const rotations
            = add_block<4, float>(instances.size(), kFloat, kNoTarget, [&](std::size_t i) {
                  Quatf const r = to_gltf(instances[i]).rotation;
                  return std::array { r.x(), r.y(), r.z(), r.w() };
              });
        auto const scales
            = add_block<3, float>(instances.size(), kFloat, kNoTarget, [&](std::size_t i) {
                  Vec3f const s = to_gltf(instances[i]).scale;
                  return std::array { s.x(), s.y(), s.z() };
              });
        return fmt::format(
            "{{\"mesh\":{},\"extensions\":{{\"EXT_mesh_gpu_instancing\":{{\"attributes\":"
            "{{\"TRANSLATION\":{},\"ROTATION\":{},\"SCALE\":{}}}}}}}}}",
            mesh, translations, rotations, scales);
    }

    // Materials.

    std::size_t material_index(Material const& material)
    {
        std::string texture;
        if (options_.textures == GlbOptions::Textures::Embedded) {
            if (material.kind == Material::Kind::Bark)
                texture = texture_reference(bark_texture_, bark_picture, kRepeat);
            else if (material.kind == Material::Kind::Leaf)
                texture = texture_reference(leaf_texture_, leaf_picture, kClampToEdge);
        }
        auto const color = material.base_color.cwiseMax(0.0f).cwiseMin(1.0f).cast<double>().eval();
        auto const text = fmt::format(
            "{{\"name\":{},\"pbrMetallicRoughness\":{{\"baseColorFactor\":[{:.6g},{:.6g},{:.6g},1],"
            "\"metallicFactor\":0,\"roughnessFactor\":{}{}}}{},\"extras\":{{\"kind\":\"{}\","
            "\"translucency\":{}}}}}",
            quoted(material.name), linear_from_srgb(color.x()), linear_from_srgb(color.y()),
            linear_from_srgb(color.z()), std::clamp(material.roughness, 0.0f, 1.0f), texture,
            is_thin(material.kind) ? ",\"doubleSided\":true" : "", kind_word(material.kind),
            std::clamp(material.translucency, 0.0f, 1.0f));
        auto const [place, is_new] = material_indices_.emplace(text, materials_.count());
        if (is_new)
            materials_.add(text);
        return place->second;
    }

    // Puts the picture into the file when it is first asked for.
    std::string texture_reference(std::optional<std::size_t>& index, GreyPicture (*picture)(),
                                  int wrap)
    {
        if (!index) {
            auto const start = binary_bytes_;
            auto const bytes = png_bytes(picture());
            put(bytes.data(), bytes.size());
            auto const image = images_.add(fmt::format(
                "{{\"bufferView\":{},\"mimeType\":\"image/png\"}}", add_view(start, kNoTarget)));
            auto const sampler = samplers_.add(fmt::format(
                "{{\"magFilter\":9729,\"minFilter\":9987,\"wrapS\":{0},\"wrapT\":{0}}}", wrap));
            index = textures_.add(fmt::format("{{\"sampler\":{},\"source\":{}}}", sampler, image));
        }
        return fmt::format(",\"baseColorTexture\":{{\"index\":{}}}", *index);
    }

    std::string json() const
    {
        std::string text = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"tractus\"},\"scene\":0";
        if (uses_instancing_)
            text += ",\"extensionsUsed\":[\"EXT_mesh_gpu_instancing\"],"
                    "\"extensionsRequired\":[\"EXT_mesh_gpu_instancing\"]";
        text += scene_.count() > 0 ? ",\"scenes\":[{\"nodes\":[" + scene_.text() + "]}]"
                                   : ",\"scenes\":[{}]";
        auto const append = [&](char const* key, JsonArray const& array) {
            if (array.count() > 0)
                text += fmt::format(",\"{}\":[", key) + array.text() + "]";
        };
        append("nodes", nodes_);
        append("meshes", meshes_);
        append("materials", materials_);
        append("textures", textures_);
        append("images", images_);
        append("samplers", samplers_);
        append("accessors", accessors_);
        append("bufferViews", views_);
        if (binary_bytes_ > 0)
            text += fmt::format(",\"buffers\":[{{\"byteLength\":{}}}]", binary_bytes_);
        return text + "}";
    }

    std::ostream& out_;
    GlbOptions const& options_;
    std::uint64_t json_room_;
    std::streamoff start_;
    std::uint64_t json_bytes_ = 0;
    std::uint64_t binary_bytes_ = 0;
    GlbSummary summary_;
    bool uses_instancing_ = false;
    JsonArray scene_, nodes_, meshes_, materials_, textures_, images_, samplers_, accessors_,
        views_;
    std::optional<std::size_t> bark_texture_;
    std::optional<std::size_t> leaf_texture_;
    std::map<std::string, std::size_t> material_indices_; // By their JSON.
    std::map<std::string, std::size_t> prototypes_;       // By their material and arrays.
};

std::uint64_t rounded_up(std::uint64_t bytes)
{
    return (bytes + 3) / 4 * 4;
}

// Room for the JSON, if the other plants are like the first. Too little costs a second try.
std::uint64_t guess_json_bytes(std::span<PlacedMesh const> plants, Mesh const& first,
                               GlbOptions const& options)
{
    std::uint64_t of_one = 400 + 1400 * first.surfaces.size() + 1000 * first.organs.size();
    if (options.instancing == GlbOptions::Instancing::Nodes)
        for (auto const& organ : first.organs)
            of_one += 220 * organ.instances.size();
    std::uint64_t bytes = 2000 + 400 * first.materials.size() + 1000 * first.organs.size();
    for (auto const& placed : plants)
        bytes += of_one + 12 * placed.name.size();
    return rounded_up(bytes);
}

Result<void> check_size(std::span<PlacedMesh const> plants)
{
    std::uint64_t bytes = 0;
    for (auto const& placed : plants)
        if (auto const* const mesh = std::get_if<Mesh const*>(&placed.mesh))
            bytes += glb_bytes(**mesh);
    if (bytes > kMaxBytes)
        return fail(Fault::User,
                    fmt::format("these {} plants take {:.1f} GiB and a glTF file holds at most 4: "
                                "write fewer plants to a file",
                                plants.size(), static_cast<double>(bytes) / 0x1p30));
    return {};
}

std::uint64_t triangle_bytes(TriangleMesh const& mesh)
{
    std::uint64_t const vertex_bytes = 8 * sizeof(float);
    std::uint64_t const index_bytes = mesh.positions_mm.size() <= 65535 ? 2 : 4;
    return mesh.positions_mm.size() * vertex_bytes + rounded_up(mesh.indices.size() * index_bytes);
}

} // namespace

std::uint64_t glb_bytes(Mesh const& mesh)
{
    std::uint64_t bytes = 0;
    for (auto const& surface : mesh.surfaces)
        bytes += triangle_bytes(surface);
    for (auto const& organ : mesh.organs)
        bytes += triangle_bytes(organ.prototype) + organ.instances.size() * 10 * sizeof(float);
    return bytes;
}

Result<GlbSummary> write_glb(std::ostream& out, std::span<PlacedMesh const> plants,
                             GlbOptions const& options)
{
    TRY(check_size(plants));
    auto const start = out.tellp();
    if (start < 0)
        return fail(Fault::User,
                    "cannot write the glTF file: its stream cannot seek, so write to a file");
    std::optional<Mesh> made;
    std::uint64_t room
        = plants.empty() ? 200 : guess_json_bytes(plants, mesh_of(plants[0], made), options);
    while (true) {
        out.seekp(start);
        GlbFile file(out, options, room);
        for (auto const& placed : plants) {
            TRY(file.add(placed, mesh_of(placed, made)));
            made.reset();
        }
        if (auto const summary = TRY(file.finish()))
            return *summary;
        room = rounded_up(file.json_bytes());
    }
}

} // namespace tractus
