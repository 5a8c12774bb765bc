#include "engine/export/glb_file.h"

#include "engine/export/gltf_frame.h"
#include "engine/export/tangents.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tractus {
namespace {

// 65,535 is no index: it restarts strips (section 3.7.2.1).
constexpr std::size_t kMostShortVertices = 65535;

auto fail_infinite(char const* what)
{
    return fail(Fault::Station,
                fmt::format("cannot write the glTF file: {} is not a finite number", what));
}

std::uint64_t rounded_up(std::uint64_t bytes)
{
    return (bytes + 3) / 4 * 4;
}

std::uint64_t triangle_bytes(MeshExtent const& extent, SurfaceFormat const& format)
{
    auto const vertex_bytes = format.positions().element_bytes + format.normals().element_bytes
        + SurfaceFormat::texture_coordinates().element_bytes
        + (format.tangents ? format.tangent_vectors().element_bytes : 0);
    return extent.vertices * static_cast<std::uint64_t>(vertex_bytes)
        + rounded_up(extent.indices * static_cast<std::uint64_t>(format.indices().element_bytes));
}

MeshExtent extent_of(TriangleMesh const& mesh)
{
    return { mesh.positions_mm.size(), mesh.indices.size() };
}

SurfaceFormat with_indices_for(SurfaceFormat format, std::size_t vertex_count)
{
    format.short_indices = vertex_count <= kMostShortVertices;
    return format;
}

std::string placement(PlacedMesh const& placed)
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

std::string level_name(LevelInFile const& level)
{
    auto const& name = level.placed->name;
    return level.number == 0 ? name : fmt::format("{} level {}", name, level.number);
}

// Of all levels.
std::string coverages(PlacedMesh const& placed)
{
    auto text = fmt::format("{}", placed.least_coverage);
    for (auto const& detail : placed.details)
        text += fmt::format(",{}", detail.least_coverage);
    return text;
}

} // namespace

SurfaceFormat PlantFormat::of(MeshPieces const& plant, MeshPieces::Surface const& surface) const
{
    auto format = with_indices_for(vertices, surface.extent.vertices);
    format.tangents = plant.has_tangents(surface.material);
    return format;
}

PlantFormat plant_format(MeshPieces const& plant, GlbOptions const& options)
{
    if (options.vertices == GlbOptions::Vertices::Float)
        return {};
    return { quantized_format(plant.bounds_mm()), { .quantized = true } };
}

std::uint64_t glb_bytes(MeshPieces const& plant, GlbOptions const& options)
{
    bool const quantized = options.vertices == GlbOptions::Vertices::Quantized;
    std::uint64_t bytes = plant.picture_png().size();
    auto const wind = [&](GlbOptions::Wind channels) {
        std::uint64_t of_one = 0;
        for (auto const& stream : wind_streams(channels))
            of_one += static_cast<std::uint64_t>(stream.format.element_bytes);
        return plant.has_wind() ? of_one : 0;
    };
    for (auto const& surface : plant.surfaces())
        bytes += surface.extent.vertices * wind(options.wind)
            + triangle_bytes(
                     surface.extent,
                     PlantFormat { .vertices = { .quantized = quantized } }.of(plant, surface));
    InstanceFormat const format { .quantized = quantized };
    auto const instance_bytes = format.translations().element_bytes
        + format.rotations().element_bytes + format.scales().element_bytes;
    auto const organ_bytes
        = static_cast<std::uint64_t>(instance_bytes) + wind(GlbOptions::Wind::Attributes);
    for (auto const& organ : plant.organs()) {
        auto const extent = extent_of(organ.prototype);
        SurfaceFormat const vertices { .tangents = plant.has_tangents(organ.prototype.material) };
        bytes += triangle_bytes(extent, with_indices_for(vertices, extent.vertices))
            + organ.instances.size() * organ_bytes;
    }
    return bytes;
}

GlbFile::GlbFile(std::ostream& out, GlbOptions const& options, std::uint64_t json_room)
    : stream_(out, json_room)
    , options_(options)
    , json_room_(json_room)
    , materials_(json_, stream_, options.textures == GlbOptions::Textures::Embedded)
{
}

Result<void> GlbFile::begin_level(LevelInFile const& level, MeshPieces const& plant,
                                  PlantFormat const& format)
{
    auto const& placed = *level.placed;
    if (stream_.file_bytes() + glb_bytes(plant, options_) > kMaxGlbBytes)
        return fail(Fault::User,
                    fmt::format("plant {} would make the glTF file larger than 4 GiB: "
                                "write fewer plants to a file",
                                quoted(placed.name)));
    if (!placed.position_mm.allFinite() || !std::isfinite(placed.rotation_rad))
        return fail_infinite("a plant's place");
    level_ = level;
    plant_ = &plant;
    format_ = format;
    primitives_ = {};
    children_ = {};
    if (level.number == 0) {
        summary_.triangles += plant.triangle_count();
        coarser_ = {};
    }
    return {};
}

// The binary part.

GlbFile::Columns GlbFile::open_triangles(MeshExtent const& extent, SurfaceFormat const& format)
{
    Columns columns;
    columns[0] = open_column(stream_, format.positions(), extent.vertices);
    columns[1] = open_column(stream_, format.normals(), extent.vertices);
    columns[2] = open_column(stream_, SurfaceFormat::texture_coordinates(), extent.vertices);
    columns[3] = open_column(stream_, format.indices(), extent.indices);
    if (format.tangents)
        columns[4] = open_column(stream_, format.tangent_vectors(), extent.vertices);
    return columns;
}

void GlbFile::open_wind(Columns& columns, std::span<WindStream const> streams, std::size_t count)
{
    for (std::size_t i = 0; plant_->has_wind() && i < streams.size(); ++i)
        columns[kFirstWindStream + i] = open_column(stream_, streams[i].format, count);
}

// To be added to other attributes; empty without wind.
std::string GlbFile::wind_attributes(Columns const& columns, std::span<WindStream const> streams,
                                     int target)
{
    std::string text;
    for (std::size_t i = 0; i < streams.size(); ++i)
        if (auto const& column = columns[kFirstWindStream + i]; column.count > 0)
            text += fmt::format(",\"{}\":{}", streams[i].name, add_accessor(json_, column, target));
    return text;
}

void GlbFile::write(Columns& columns, EncodedPiece const& piece)
{
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (!piece.streams[i].empty())
            stream_.write(columns[i].block, piece.streams[i]);
}

// Surfaces.

std::string GlbFile::add_primitive(Columns const& columns, EncodedPiece const& limits,
                                   std::size_t material)
{
    auto const positions
        = add_accessor(json_, columns[0], kArrayBuffer, limits_text(limits.low, limits.high));
    auto const normals = add_accessor(json_, columns[1], kArrayBuffer);
    auto const texture = add_accessor(json_, columns[2], kArrayBuffer);
    auto const indices = add_accessor(json_, columns[3], kElementArrayBuffer);
    auto const tangents = columns[4].count > 0
        ? fmt::format(",\"TANGENT\":{}", add_accessor(json_, columns[4], kArrayBuffer))
        : std::string();
    auto const wind = wind_attributes(columns, wind_streams(options_.wind), kArrayBuffer);
    return fmt::format("{{\"attributes\":{{\"POSITION\":{},\"NORMAL\":{},\"TEXCOORD_0\":{}{}{}}},"
                       "\"indices\":{},\"material\":{}}}",
                       positions, normals, texture, tangents, wind, indices, material);
}

Result<void> GlbFile::add_surface_piece(std::size_t index, bool is_last, EncodedPiece const& piece)
{
    auto const& surface = plant_->surfaces()[index];
    if (!open_) {
        open_index_ = plant_->picture_png().empty()
            ? materials_.index_of(plant_->material(surface.material))
            : materials_.add_picture(plant_->picture_png());
        open_ = open_triangles(surface.extent, format_.of(*plant_, surface));
        open_wind(*open_, wind_streams(options_.wind), surface.extent.vertices);
        limits_ = {};
    }
    if (!piece.is_finite)
        return fail_infinite("a coordinate");
    limits_.low = limits_.low.cwiseMin(piece.low);
    limits_.high = limits_.high.cwiseMax(piece.high);
    write(*open_, piece);
    if (is_last) {
        primitives_.add(add_primitive(*open_, limits_, open_index_));
        open_.reset();
    }
    return stream_.check();
}

// Organs.

// Equal prototypes with equal materials are written once.
Result<std::size_t> GlbFile::prototype_index(TriangleMesh const& prototype)
{
    auto const& material = plant_->material(prototype.material);
    auto const material_index = materials_.index_of(material);
    std::string key = fmt::format("{} ", material_index);
    auto const append = [&](auto const& values) {
        key.append(reinterpret_cast<char const*>(values.data()), values.size() * sizeof values[0]);
    };
    append(prototype.positions_mm);
    append(prototype.normals);
    append(prototype.texture_coordinates);
    append(prototype.indices);
    if (auto const known = prototypes_.find(key); known != prototypes_.end())
        return known->second;
    auto format = with_indices_for({}, prototype.positions_mm.size());
    format.tangents = plant_->has_tangents(prototype.material);
    auto triangles = view_of(prototype);
    BulkVector<Eigen::Vector4f> tangents;
    if (format.tangents) {
        find_tangents(triangles, tangents);
        triangles.tangents = tangents;
    }
    EncodedPiece encoded;
    encode_triangles(triangles, format, encoded);
    if (!encoded.is_finite)
        return fail_infinite("a coordinate of an organ");
    auto columns = open_triangles(extent_of(prototype), format);
    write(columns, encoded);
    auto const index
        = json_.meshes.add(fmt::format("{{\"name\":{},\"primitives\":[{}]}}", quoted(material.name),
                                       add_primitive(columns, encoded, material_index)));
    prototypes_.emplace(std::move(key), index);
    return index;
}

Result<void> GlbFile::add_instances(std::size_t index, bool is_last, EncodedPiece const& piece)
{
    auto const& organ = plant_->organs()[index];
    if (!piece.is_finite)
        return fail_infinite("an organ's place");
    if (!open_) {
        open_index_ = TRY(prototype_index(organ.prototype));
        if (options_.organs == GlbOptions::Organs::Nodes) {
            add_organ_nodes(open_index_, organ.instances, plant_->organ_wind(index));
            return stream_.check();
        }
        open_ = Columns();
        auto& columns = *open_;
        columns[0] = open_column(stream_, InstanceFormat::translations(), organ.instances.size());
        columns[1] = open_column(stream_, format_.instances.rotations(), organ.instances.size());
        columns[2] = open_column(stream_, InstanceFormat::scales(), organ.instances.size());
        open_wind(columns, wind_streams(GlbOptions::Wind::Attributes), organ.instances.size());
    }
    write(*open_, piece);
    if (!is_last)
        return stream_.check();
    json_.required_extensions.insert("EXT_mesh_gpu_instancing");
    auto const& columns = *open_;
    auto const translations = add_accessor(json_, columns[0], kNoTarget);
    auto const rotations = add_accessor(json_, columns[1], kNoTarget);
    auto const scales = add_accessor(json_, columns[2], kNoTarget);
    auto const wind
        = wind_attributes(columns, wind_streams(GlbOptions::Wind::Attributes), kNoTarget);
    add_child(
        fmt::format("{{\"mesh\":{},\"extensions\":{{\"EXT_mesh_gpu_instancing\":"
                    "{{\"attributes\":{{\"TRANSLATION\":{},\"ROTATION\":{},\"SCALE\":{}{}}}}}}}}}",
                    open_index_, translations, rotations, scales, wind));
    open_.reset();
    return stream_.check();
}

void GlbFile::add_organ_nodes(std::size_t mesh, std::span<InstanceTransform const> instances,
                              std::span<WindVertex const> wind)
{
    for (std::size_t i = 0; i < instances.size(); ++i) {
        auto const placed = to_gltf(instances[i]);
        auto const& t = placed.translation_mm;
        auto const& r = placed.rotation;
        auto const& s = placed.scale;
        add_child(fmt::format("{{\"mesh\":{},\"translation\":[{},{},{}],\"rotation\":[{},{},{},{}],"
                              "\"scale\":[{},{},{}]{}}}",
                              mesh, t.x(), t.y(), t.z(), r.x(), r.y(), r.z(), r.w(), s.x(), s.y(),
                              s.z(), wind.empty() ? std::string() : wind_extras(wind[i])));
    }
}

// Nodes.

void GlbFile::add_child(std::string const& node)
{
    children_.add(fmt::format("{}", json_.nodes.add(node)));
}

// What the plant's node says of its own mesh: nothing where there are no tubes or polygons, and
// nothing where a child says it, which takes quantised numbers to metres.
std::string GlbFile::surfaces_reference()
{
    if (primitives_.count() == 0)
        return {};
    auto const mesh = json_.meshes.add(fmt::format("{{\"name\":{},\"primitives\":[{}]}}",
                                                   quoted(level_name(level_)), primitives_.text()));
    auto const& vertices = format_.vertices;
    if (!vertices.quantized)
        return fmt::format(",\"mesh\":{}", mesh);
    json_.required_extensions.insert("KHR_mesh_quantization");
    add_child(fmt::format("{{\"mesh\":{0},\"translation\":[{1},{2},{3}],\"scale\":[{4},{4},{4}]}}",
                          mesh, vertices.origin_m.x(), vertices.origin_m.y(), vertices.origin_m.z(),
                          vertices.step_m));
    return {};
}

// The coarser levels stand beside the scene; who does not know the extension shows the finest.
void GlbFile::end_level()
{
    std::string node = "{\"name\":" + quoted(level_name(level_)) + placement(*level_.placed)
        + surfaces_reference();
    if (children_.count() > 0)
        node += ",\"children\":[" + children_.text() + "]";
    if (level_.number == 0)
        finest_ = node;
    else
        coarser_.add(fmt::format("{}", json_.nodes.add(node + "}")));
    if (!level_.is_last())
        return;
    if (coarser_.count() > 0) {
        json_.optional_extensions.insert("MSFT_lod");
        finest_ += fmt::format(",\"extensions\":{{\"MSFT_lod\":{{\"ids\":[{}]}}}},"
                               "\"extras\":{{\"MSFT_screencoverage\":[{}]}}",
                               coarser_.text(), coverages(*level_.placed));
    }
    json_.scene.add(fmt::format("{}", json_.nodes.add(finest_ + "}")));
}

Result<std::optional<GlbSummary>> GlbFile::finish()
{
    auto const text = json_.text(stream_.binary_bytes());
    json_bytes_ = text.size();
    if (text.size() > json_room_)
        return std::optional<GlbSummary>();
    summary_.bytes = stream_.file_bytes();
    if (summary_.bytes > kMaxGlbBytes)
        return fail(Fault::User,
                    "the glTF file would be larger than 4 GiB: write fewer plants to a file");
    TRY(stream_.finish(text));
    return std::optional(summary_);
}

} // namespace tractus
