#pragma once

#include "engine/export/glb_column.h"
#include "engine/export/glb_stream.h"
#include "engine/export/glb_writer.h"
#include "engine/export/gltf_json.h"
#include "engine/export/gltf_materials.h"
#include "engine/export/mesh_pieces.h"
#include "engine/export/piece_encoder.h"
#include "engine/export/wind_channels.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tractus::exports {

// Number formats in which the pieces of a plant are written.
struct PlantFormat {
    // Format of surfaces, without the size of indices and the tangents, which of() adds.
    SurfaceFormat vertices {};
    InstanceFormat instances {};

    SurfaceFormat of(MeshPieces const& plant, MeshPieces::Surface const& surface) const;
};

PlantFormat plant_format(MeshPieces const& plant, GlbOptions const& options);

// Returns the size of a plant in the binary chunk, without textures. If the plant is compressed the
// size is an estimate.
std::uint64_t glb_bytes(MeshPieces const& plant, GlbOptions const& options);

// One level of detail of a plant, to be written as nodes of its own.
struct LevelInFile {
    PlacedMesh const* placed = nullptr;
    std::size_t number = 0; // 0: the plant itself; 1 and more: its coarser levels, finest first.

    MeshSource const& source() const
    {
        return number == 0 ? placed->mesh : placed->details[number - 1].mesh;
    }
    bool is_last() const { return number == placed->details.size(); }
};

// One attempt to write a .glb file with a given space for its JSON. Plants are written one after
// another, each from its finest to its coarsest level. Of each level the pieces of the surfaces are
// written first, then those of the organs, all in order.
class GlbFile {
public:
    GlbFile(std::ostream& out, GlbOptions const& options, std::uint64_t json_room);

    Result<void> begin_level(LevelInFile const& level, MeshPieces const& plant,
                             PlantFormat const& format);
    Result<void> add_surface_piece(std::size_t surface, bool is_last, EncodedPiece const& piece);
    Result<void> add_instances(std::size_t organ, bool is_last, EncodedPiece const& piece);
    void end_level();

    // Fills in the headers and the JSON. If the JSON exceeds its space, returns no value;
    // json_bytes() then returns the size of the JSON.
    Result<std::optional<GlbSummary>> finish();

    std::uint64_t json_bytes() const { return json_bytes_; }

private:
    using Columns = std::array<GlbColumn, kMaxStreams>;

    bool is_compressed() const { return options_.vertices == GlbOptions::Vertices::Compressed; }
    // Opens the column for stream number `stream`. If the file is compressed, `piece` must contain
    // the whole column.
    GlbColumn open(NumberFormat const& format, std::size_t count, std::size_t stream,
                   EncodedPiece const& piece);
    Columns open_triangles(mesh::MeshExtent const& extent, SurfaceFormat const& format,
                           EncodedPiece const& piece);
    Columns open_instances(std::size_t count, EncodedPiece const& piece);
    void open_wind(Columns& columns, std::span<WindStream const> streams, std::size_t count,
                   EncodedPiece const& piece);
    void add_wind(Json& attributes, Columns const& columns, std::span<WindStream const> streams,
                  int target);
    void write(Columns& columns, EncodedPiece const& piece);
    Json add_primitive(Columns const& columns, EncodedPiece const& limits, std::size_t material);
    Result<std::size_t> prototype_index(mesh::TriangleMesh const& prototype);
    void add_organ_nodes(std::size_t mesh, std::span<mesh::InstanceTransform const> instances,
                         std::span<mesh::WindVertex const> wind);
    void add_instanced_node(Columns const& columns);
    void add_surfaces(Json& node);
    Result<void> check() const;
    void add_child(Json const& node);

    GlbStream stream_;
    GlbOptions options_;
    std::uint64_t json_room_;
    GltfJson json_;
    GltfMaterials materials_;
    // Index in the JSON's "meshes" of each prototype, by the prototype's material and the bytes of
    // its arrays.
    std::map<std::string, std::size_t> prototypes_;
    GlbSummary summary_;
    std::uint64_t json_bytes_ = 0;

    // The following members belong to the level that is being written.
    LevelInFile level_;
    MeshPieces const* plant_ = nullptr;
    PlantFormat format_;
    Json primitives_;
    std::vector<std::size_t> children_;
    // The node of the plant's finest level, to which the coarser levels are still to be added.
    Json finest_;
    std::vector<std::size_t> coarser_; // Node indices of the plant's coarser levels.
    // Columns of the surface or organ whose pieces are being written; no value between them.
    std::optional<Columns> open_;
    EncodedPiece limits_; // Limits of the positions written to open_ so far.
    // Index of the material of the surface, or of the mesh of the organ, that is being written.
    std::optional<std::size_t> open_index_;
};

} // namespace tractus::exports
