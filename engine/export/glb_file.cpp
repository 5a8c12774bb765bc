#include "engine/export/glb_file.h"

#include "engine/export/compressed_piece.h"
#include "engine/export/gltf_frame.h"
#include "engine/export/tangents.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::exports {
namespace {

// Maximum number of vertices that 16-bit indices can address. Index 65,535 is excluded, since it
// restarts strips (glTF 2.0 section 3.7.2.1).
constexpr std::size_t kMaxShortVertices = 65535;
// Expected factor by which wind data are compressed. It is high, since most vertices of a branch
// have the same data.
constexpr std::uint64_t kWindCompression = 8;

auto fail_large(PlacedMesh const& placed)
{
    return fail(Fault::User,
                fmt::format("plant {} would make the glTF file larger than 4 GiB: "
                            "write fewer plants to a file",
                            json_text(placed.name)));
}

auto fail_infinite(char const* what)
{
    return fail(Fault::Station,
                fmt::format("cannot write the glTF file: {} is not a finite number", what));
}

std::uint64_t rounded_up(std::uint64_t bytes)
{
    return (bytes + 3) / 4 * 4;
}

std::uint64_t triangle_bytes(mesh::MeshExtent const& extent, SurfaceFormat const& format)
{
    auto const vertex_bytes = format.positions().element_bytes + format.normals().element_bytes
        + format.texture_coordinates().element_bytes
        + (format.tangents ? format.tangent_vectors().element_bytes : 0);
    return extent.vertices * static_cast<std::uint64_t>(vertex_bytes)
        + rounded_up(extent.indices * static_cast<std::uint64_t>(format.indices().element_bytes));
}

// Returns the expected compressed size of triangles, in bytes, from the average of exported trees
// and plant collections.
std::uint64_t compressed_triangle_bytes(mesh::MeshExtent const& extent, SurfaceFormat const& format)
{
    return extent.vertices * (format.tangents ? 11 : 9) + extent.indices;
}

mesh::MeshExtent extent_of(mesh::TriangleMesh const& mesh)
{
    return { mesh.positions_mm.size(), mesh.indices.size() };
}

SurfaceFormat with_indices_for(SurfaceFormat format, std::size_t vertex_count)
{
    format.short_indices = vertex_count <= kMaxShortVertices;
    return format;
}

void add_placement(Json& node, PlacedMesh const& placed)
{
    if (!placed.position_mm.isZero(0))
        node["translation"] = json_numbers(to_gltf(placed.position_mm));
    if (placed.rotation_rad != 0)
        node["rotation"] = { 0, json_number(std::sin(placed.rotation_rad / 2)), 0,
                             json_number(std::cos(placed.rotation_rad / 2)) };
}

std::string level_name(LevelInFile const& level)
{
    auto const& name = level.placed->name;
    return level.number == 0 ? name : fmt::format("{} level {}", name, level.number);
}

void encode_prototype(TriangleView const& triangles, SurfaceFormat format, bool compressed,
                      EncodedPiece& piece)
{
    if (compressed)
        format.short_indices = false; // The codec of indices requires 32 bits.
    encode_triangles(triangles, format, piece);
    if (compressed)
        compress_triangles(format, {}, piece);
}

// Returns the minimum coverages of a plant and of its levels of detail, as an array.
Json coverages(PlacedMesh const& placed)
{
    auto of_levels = Json::array({ json_number(placed.min_coverage) });
    for (auto const& detail : placed.details)
        of_levels.push_back(json_number(detail.min_coverage));
    return of_levels;
}

} // namespace

SurfaceFormat PlantFormat::of(MeshPieces const& plant, MeshPieces::Surface const& surface) const
{
    auto format
        = vertices.filtered ? vertices : with_indices_for(vertices, surface.extent.vertices);
    format.tangents = plant.has_tangents(surface.material);
    return format;
}

PlantFormat plant_format(MeshPieces const& plant, GlbOptions const& options)
{
    if (options.vertices == GlbOptions::Vertices::Float)
        return {};
    PlantFormat format { quantized_format(plant.bounds_mm()), { .quantized = true } };
    format.vertices.filtered = options.vertices == GlbOptions::Vertices::Compressed;
    return format;
}

std::uint64_t glb_bytes(MeshPieces const& plant, GlbOptions const& options)
{
    bool const quantized = options.vertices != GlbOptions::Vertices::Float;
    bool const compressed = options.vertices == GlbOptions::Vertices::Compressed;
    auto const bytes_of = compressed ? compressed_triangle_bytes : triangle_bytes;
    std::uint64_t bytes = plant.picture_png().size();
    auto const wind = [&](GlbOptions::Wind channels) {
        std::uint64_t of_one = 0;
        for (auto const& stream : wind_streams(channels))
            of_one += static_cast<std::uint64_t>(stream.format.element_bytes);
        return plant.has_wind() ? of_one / (compressed ? kWindCompression : 1) : 0;
    };
    for (auto const& surface : plant.surfaces())
        bytes += surface.extent.vertices * wind(options.wind)
            + bytes_of(surface.extent,
                       PlantFormat { .vertices = { .quantized = quantized } }.of(plant, surface));
    InstanceFormat const format { .quantized = quantized };
    auto const instance_bytes = format.translations().element_bytes
        + format.rotations().element_bytes + format.scales().element_bytes;
    auto const organ_bytes
        = static_cast<std::uint64_t>(instance_bytes) + wind(GlbOptions::Wind::Attributes);
    for (auto const& organ : plant.organs()) {
        auto const extent = extent_of(organ.prototype);
        SurfaceFormat const vertices { .tangents = plant.has_tangents(organ.prototype.material) };
        bytes += bytes_of(extent, with_indices_for(vertices, extent.vertices))
            + organ.instances.size() * organ_bytes;
    }
    return bytes;
}

GlbFile::GlbFile(std::ostream& out, GlbOptions const& options, std::uint64_t json_room)
    : stream_(out, json_room)
    , options_(options)
    , json_room_(json_room)
    , materials_(json_, stream_, options.textures == GlbOptions::Textures::Embedded,
                 options.bark_px)
{
}

Result<void> GlbFile::begin_level(LevelInFile const& level, MeshPieces const& plant,
                                  PlantFormat const& format)
{
    auto const& placed = *level.placed;
    if (!is_compressed() && stream_.file_bytes() + glb_bytes(plant, options_) > kMaxGlbBytes)
        return fail_large(placed);
    if (!placed.position_mm.allFinite() || !std::isfinite(placed.rotation_rad))
        return fail_infinite("a plant's place");
    level_ = level;
    plant_ = &plant;
    format_ = format;
    primitives_ = Json::array();
    open_index_.reset();
    children_.clear();
    if (level.number == 0) {
        summary_.triangles += plant.triangle_count();
        coarser_.clear();
    }
    return {};
}

// The following functions write to the binary chunk.

GlbColumn GlbFile::open(NumberFormat const& format, std::size_t count, std::size_t stream,
                        EncodedPiece const& piece)
{
    if (!is_compressed())
        return open_column(stream_, format, count);
    return open_compressed_column(stream_, json_, format, count, piece.streams[stream].size());
}

GlbFile::Columns GlbFile::open_triangles(mesh::MeshExtent const& extent,
                                         SurfaceFormat const& format, EncodedPiece const& piece)
{
    Columns columns;
    columns[0] = open(format.positions(), extent.vertices, 0, piece);
    columns[1] = open(format.normals(), extent.vertices, 1, piece);
    columns[2] = open(format.texture_coordinates(), extent.vertices, 2, piece);
    columns[3] = open(format.indices(), extent.indices, 3, piece);
    if (format.tangents)
        columns[4] = open(format.tangent_vectors(), extent.vertices, 4, piece);
    return columns;
}

GlbFile::Columns GlbFile::open_instances(std::size_t count, EncodedPiece const& piece)
{
    Columns columns;
    columns[0] = open(InstanceFormat::translations(), count, 0, piece);
    columns[1] = open(format_.instances.rotations(), count, 1, piece);
    columns[2] = open(InstanceFormat::scales(), count, 2, piece);
    open_wind(columns, wind_streams(GlbOptions::Wind::Attributes), count, piece);
    return columns;
}

void GlbFile::open_wind(Columns& columns, std::span<WindStream const> streams, std::size_t count,
                        EncodedPiece const& piece)
{
    for (std::size_t i = 0; plant_->has_wind() && i < streams.size(); ++i)
        columns[kFirstWindStream + i] = open(streams[i].format, count, kFirstWindStream + i, piece);
}

void GlbFile::add_wind(Json& attributes, Columns const& columns,
                       std::span<WindStream const> streams, int target)
{
    for (std::size_t i = 0; i < streams.size(); ++i)
        if (auto const& column = columns[kFirstWindStream + i]; column.count > 0)
            attributes[std::string(streams[i].name)] = add_accessor(json_, column, target);
}

void GlbFile::write(Columns& columns, EncodedPiece const& piece)
{
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (!piece.streams[i].empty())
            stream_.write(columns[i].block, piece.streams[i]);
}

// The following functions write surfaces.

Json GlbFile::add_primitive(Columns const& columns, EncodedPiece const& limits,
                            std::size_t material)
{
    auto primitive = add_triangles(json_, columns, limits);
    add_wind(primitive["attributes"], columns, wind_streams(options_.wind), kArrayBuffer);
    primitive["material"] = material;
    return primitive;
}

// Writes a piece of a surface. If the file is compressed, each piece becomes a primitive of its
// own.
Result<void> GlbFile::add_surface_piece(std::size_t index, bool is_last, EncodedPiece const& piece)
{
    auto const& surface = plant_->surfaces()[index];
    if (!open_index_)
        open_index_ = plant_->picture_png().empty()
            ? materials_.index_of(plant_->material(surface.material))
            : materials_.add_picture(plant_->picture_png());
    if (!piece.is_finite)
        return fail_infinite("a coordinate");
    // If many vertices of a mesh are unused, a compressed piece of it may have no triangles.
    bool const has_triangles = !is_compressed() || piece.extent.indices > 0;
    if (!open_ && has_triangles) {
        auto const& extent = is_compressed() ? piece.extent : surface.extent;
        open_ = open_triangles(
            extent, with_indices_for(format_.of(*plant_, surface), extent.vertices), piece);
        open_wind(*open_, wind_streams(options_.wind), extent.vertices, piece);
        limits_ = {};
    }
    limits_.low = limits_.low.cwiseMin(piece.low);
    limits_.high = limits_.high.cwiseMax(piece.high);
    if (open_)
        write(*open_, piece);
    if (open_ && (is_last || is_compressed())) {
        primitives_.push_back(add_primitive(*open_, limits_, *open_index_));
        open_.reset();
    }
    if (is_last)
        open_index_.reset();
    return check();
}

Result<void> GlbFile::check() const
{
    if (stream_.file_bytes() > kMaxGlbBytes)
        return fail_large(*level_.placed);
    return stream_.check();
}

// The following functions write organs.

// Returns the index of a prototype's mesh, which is written unless an equal prototype with an equal
// material has been written already.
Result<std::size_t> GlbFile::prototype_index(mesh::TriangleMesh const& prototype)
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
    encode_prototype(triangles, format, is_compressed(), encoded);
    if (!encoded.is_finite)
        return fail_infinite("a coordinate of an organ");
    auto columns = open_triangles(extent_of(prototype), format, encoded);
    write(columns, encoded);
    auto const index = json_.meshes.add(
        { { "name", material.name },
          { "primitives", Json::array({ add_primitive(columns, encoded, material_index) }) } });
    prototypes_.emplace(std::move(key), index);
    return index;
}

// Writes a piece of an organ's instances. If the file is compressed, each piece becomes a node of
// its own.
Result<void> GlbFile::add_instances(std::size_t index, bool is_last, EncodedPiece const& piece)
{
    auto const& organ = plant_->organs()[index];
    if (!piece.is_finite)
        return fail_infinite("an organ's place");
    if (!open_index_)
        open_index_ = TRY(prototype_index(organ.prototype));
    if (options_.organs == GlbOptions::Organs::Nodes) {
        add_organ_nodes(*open_index_, organ.instances, plant_->organ_wind(index));
    } else {
        if (!open_)
            open_ = open_instances(is_compressed() ? piece.extent.vertices : organ.instances.size(),
                                   piece);
        write(*open_, piece);
        if (is_last || is_compressed()) {
            add_instanced_node(*open_);
            open_.reset();
        }
    }
    if (is_last)
        open_index_.reset();
    return check();
}

void GlbFile::add_instanced_node(Columns const& columns)
{
    json_.required_extensions.insert("EXT_mesh_gpu_instancing");
    Json attributes;
    attributes["TRANSLATION"] = add_accessor(json_, columns[0], kNoTarget);
    attributes["ROTATION"] = add_accessor(json_, columns[1], kNoTarget);
    attributes["SCALE"] = add_accessor(json_, columns[2], kNoTarget);
    add_wind(attributes, columns, wind_streams(GlbOptions::Wind::Attributes), kNoTarget);
    Json node;
    node["mesh"] = *open_index_;
    node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = std::move(attributes);
    add_child(node);
}

void GlbFile::add_organ_nodes(std::size_t mesh, std::span<mesh::InstanceTransform const> instances,
                              std::span<mesh::WindVertex const> wind)
{
    Json node; // The node is reused for all organs, so that its members are allocated once.
    node["mesh"] = mesh;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        auto const placed = to_gltf(instances[i]);
        node["translation"] = json_numbers(placed.translation_mm);
        node["rotation"] = json_numbers(placed.rotation.coeffs()); // The order is x, y, z, w.
        node["scale"] = json_numbers(placed.scale);
        if (!wind.empty())
            node["extras"] = wind_extras(wind[i]);
        add_child(node);
    }
}

// The following functions write nodes.

void GlbFile::add_child(Json const& node)
{
    children_.push_back(json_.nodes.add(node));
}

// Adds the mesh of the plant's surfaces to its node; does nothing if there are none. A quantised
// mesh goes into a child node, which scales it to metres.
void GlbFile::add_surfaces(Json& node)
{
    if (primitives_.empty())
        return;
    auto const mesh = json_.meshes.add(
        { { "name", level_name(level_) }, { "primitives", std::move(primitives_) } });
    auto const& vertices = format_.vertices;
    if (!vertices.quantized) {
        node["mesh"] = mesh;
        return;
    }
    json_.required_extensions.insert("KHR_mesh_quantization");
    add_child({ { "mesh", mesh },
                { "translation", json_numbers(vertices.origin_m) },
                { "scale", json_numbers(Vec3::Constant(vertices.step_m).eval()) } });
}

// Adds the node of a level. Coarser levels are not part of the scene, so that programs that do not
// know the extension MSFT_lod show the finest level.
void GlbFile::end_level()
{
    Json node;
    node["name"] = level_name(level_);
    add_placement(node, *level_.placed);
    add_surfaces(node);
    if (!children_.empty())
        node["children"] = children_;
    if (level_.number == 0)
        finest_ = std::move(node);
    else
        coarser_.push_back(json_.nodes.add(node));
    if (!level_.is_last())
        return;
    if (!coarser_.empty()) {
        json_.optional_extensions.insert("MSFT_lod");
        finest_["extensions"]["MSFT_lod"]["ids"] = coarser_;
        finest_["extras"]["MSFT_screencoverage"] = coverages(*level_.placed);
    }
    json_.scene.push_back(json_.nodes.add(finest_));
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

} // namespace tractus::exports
