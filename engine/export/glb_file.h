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

// Number formats of a plant's pieces.
struct PlantFormat {
    SurfaceFormat vertices {}; // Format of surfaces, except for the size of indices.
    InstanceFormat instances {};

    SurfaceFormat of(MeshPieces const& plant, MeshPieces::Surface const& surface) const;
};

PlantFormat plant_format(MeshPieces const& plant, GlbOptions const& options);

// Size of a plant in the binary chunk, without textures; approximate if it is compressed.
std::uint64_t glb_bytes(MeshPieces const& plant, GlbOptions const& options);

// One level of detail of a plant being written.
struct LevelInFile {
    PlacedMesh const* placed = nullptr;
    std::size_t number = 0; // 0: the plant itself; 1 and more: its coarser levels, finest first.

    MeshSource const& source() const
    {
        return number == 0 ? placed->mesh : placed->details[number - 1].mesh;
    }
    bool is_last() const { return number == placed->details.size(); }
};

// One attempt to write a .glb file with a given space for its JSON. Plants come one after another,
// each from its finest to its coarsest level; of each level first the surfaces, then the organs,
// all pieces in order.
class GlbFile {
public:
    GlbFile(std::ostream& out, GlbOptions const& options, std::uint64_t json_room);

    Result<void> begin_level(LevelInFile const& level, MeshPieces const& plant,
                             PlantFormat const& format);
    Result<void> add_surface_piece(std::size_t surface, bool is_last, EncodedPiece const& piece);
    Result<void> add_instances(std::size_t organ, bool is_last, EncodedPiece const& piece);
    void end_level();

    // Fills in the headers and the JSON. Returns no value if the JSON exceeds its space;
    // json_bytes() then returns its size.
    Result<std::optional<GlbSummary>> finish();

    std::uint64_t json_bytes() const { return json_bytes_; }

private:
    using Columns = std::array<GlbColumn, kMaxStreams>;

    bool is_compressed() const { return options_.vertices == GlbOptions::Vertices::Compressed; }
    // Opens the column of a stream; if it is compressed, `piece` contains the whole column.
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
    // Index in the JSON's meshes of each prototype, by its material and the bytes of its arrays.
    std::map<std::string, std::size_t> prototypes_;
    GlbSummary summary_;
    std::uint64_t json_bytes_ = 0;

    // State of the level that is being written.
    LevelInFile level_;
    MeshPieces const* plant_ = nullptr;
    PlantFormat format_;
    Json primitives_;
    std::vector<std::size_t> children_;
    Json finest_; // The plant's node, to which the coarser levels are still to be added.
    std::vector<std::size_t> coarser_;      // Node indices of the plant's coarser levels.
    std::optional<Columns> open_;           // The surface or organ whose pieces are being written.
    EncodedPiece limits_;                   // Limits of the positions in open_ so far.
    std::optional<std::size_t> open_index_; // Index of the surface's material or the organ's mesh.
};

} // namespace tractus::exports
