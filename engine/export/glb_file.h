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

// How a plant's pieces are written.
struct PlantFormat {
    SurfaceFormat vertices {}; // Format of surfaces, but for the size of indices.
    InstanceFormat instances {};

    SurfaceFormat of(MeshPieces const& plant, MeshPieces::Surface const& surface) const;
};

PlantFormat plant_format(MeshPieces const& plant, GlbOptions const& options);

// Bytes that a plant takes in the binary chunk, textures of materials not counted; about as many if
// it is compressed.
std::uint64_t glb_bytes(MeshPieces const& plant, GlbOptions const& options);

// A plant as it comes into a file, once for each of its levels of detail.
struct LevelInFile {
    PlacedMesh const* placed = nullptr;
    std::size_t number = 0; // 0: the plant itself; then its details.

    MeshSource const& source() const
    {
        return number == 0 ? placed->mesh : placed->details[number - 1].mesh;
    }
    bool is_last() const { return number == placed->details.size(); }
};

// One try at a .glb file, with a given room for its JSON. Plants come one after another, each from
// its finest level to its coarsest; of each level its surfaces, then its organs, all pieces in
// order.
class GlbFile {
public:
    GlbFile(std::ostream& out, GlbOptions const& options, std::uint64_t json_room);

    Result<void> begin_level(LevelInFile const& level, MeshPieces const& plant,
                             PlantFormat const& format);
    Result<void> add_surface_piece(std::size_t surface, bool is_last, EncodedPiece const& piece);
    Result<void> add_instances(std::size_t organ, bool is_last, EncodedPiece const& piece);
    void end_level();

    // Fills in headers and JSON. No value if the JSON does not fit in its room: then
    // `json_bytes()` says how much it takes.
    Result<std::optional<GlbSummary>> finish();

    std::uint64_t json_bytes() const { return json_bytes_; }

private:
    using Columns = std::array<GlbColumn, kMostStreams>;

    bool is_compressed() const { return options_.vertices == GlbOptions::Vertices::Compressed; }
    // Of a stream of `piece`, which is all of the column if it is compressed.
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
    std::map<std::string, std::size_t> prototypes_; // Keyed by material and arrays.
    GlbSummary summary_;
    std::uint64_t json_bytes_ = 0;

    // The plant that is being written.
    LevelInFile level_;
    MeshPieces const* plant_ = nullptr;
    PlantFormat format_;
    Json primitives_;
    std::vector<std::size_t> children_;
    Json finest_; // Its plant's node, to which the coarser ones are yet to be added.
    std::vector<std::size_t> coarser_;      // Nodes of the coarser levels.
    std::optional<Columns> open_;           // The surface or organ whose pieces are coming.
    EncodedPiece limits_;                   // Limits of its positions so far.
    std::optional<std::size_t> open_index_; // Its material, or its prototype.
};

} // namespace tractus::exports
