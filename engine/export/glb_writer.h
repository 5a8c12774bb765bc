#pragma once

#include "engine/base/result.h"
#include "engine/export/bark_pictures.h"
#include "engine/export/placed_mesh.h"

#include <cstdint>
#include <functional>
#include <ostream>
#include <span>

namespace tractus::exports {

// Maximum size of a .glb file, whose header states the size as a 32-bit number (glTF 2.0 section
// 4.4.2).
constexpr std::uint64_t kMaxGlbBytes = 0xFFFFFFFF;

struct GlbSummary {
    std::uint64_t bytes = 0; // Size of the whole file.
    // Number of triangles of the finest levels, including those of every instance.
    std::uint64_t triangles = 0;
    // Approximate size of the file with Vertices::Compressed; set only for before_writing().
    std::uint64_t compressed_bytes = 0;
    std::size_t files = 1; // Number of files that have these sizes together.
};

struct GlbOptions {
    // How the copies of an organ, such as leaves, are written.
    enum class Organs {
        // As part of the plant's mesh, one primitive per material: readable by every program.
        Merged,
        Instanced, // By EXT_mesh_gpu_instancing, which the reader must support: small and fast.
        // As one node per organ: readable by every program, but many programs are slow with so many
        // nodes.
        Nodes,
    };
    // Whether texture pictures of bark and leaf veins are included in the file.
    enum class Textures {
        Embedded,
        None,
    };

    // Number format of the vertices of tubes and polygons.
    enum class Vertices {
        Float, // 32 bytes per vertex.
        // By KHR_mesh_quantization, which the reader must support: 20 bytes per vertex. Positions
        // are rounded to 1/65,532 of the plant's size, normals to 8 bits, and rotations of organs
        // to 16.
        Quantized,
        // Quantized, and compressed by EXT_meshopt_compression, which the reader must also support:
        // about 13 bytes per vertex including triangles. Directions are rounded to 1.3 degrees,
        // texture coordinates to 1/4096.
        Compressed,
    };

    // Where the wind data of vertices, including those of merged organs, are written for plants
    // that have them (PlantToMesh::wind). Instanced organs always have wind data as attributes;
    // organs that are nodes have them in their extras, under the names of the attributes.
    //
    // Attributes:         _PIVOT and _AXIS (x, y, z), _LEVEL, _PHASE and _BEND.
    // TextureCoordinates: TEXCOORD_1 (pivot x, y), _2 (pivot z, bend), _3 (axis x, y),
    //                     _4 (axis z, level + phase).
    // Colours:            COLOR_0, 8 bits each: phase, bend, level / 8 (at most 1), 1.
    //
    // Pivots and axes are in the frame of the plant's node, +y up, for every value of `vertices`.
    // Pivots are in metres; axes are unit vectors.
    enum class Wind { Attributes, TextureCoordinates, Colours };
    Wind wind = Wind::Attributes;

    Organs organs = Organs::Merged;
    Textures textures = Textures::Embedded;
    Vertices vertices = Vertices::Float;
    // Width and height of the pictures of each kind of bark, up to kMaxBarkPicture_px.
    int bark_px = kBarkPicture_px;

    // Called with the expected summary before anything is written. The expected sizes and triangles
    // are those of the first plant times the number of plants, without JSON and textures.
    std::function<void(GlbSummary const& expected)> before_writing {};
};

// Writes plants as one binary glTF 2.0 file, in metres, +y up. Each plant has a node and a mesh
// with one primitive per material (several if compressed); GlbOptions::organs says how organs are
// written. Equal materials, prototypes and textures are written once. Levels of detail use
// MSFT_lod: they are separate nodes, and the plant's extras have the minimum shares of the screen's
// area (MSFT_screencoverage). The same plants always give the same bytes.
//
// Plants are written one after another, in pieces: while one piece is written, others are made on
// other threads. A plant given as PlantToMesh is meshed piece by piece, so that memory holds only
// two or three plants and a few megabytes of triangles. The JSON comes first in the file but is
// filled in at the end. So `out` must be binary and seekable (a file, or a std::ostringstream). The
// file begins at the stream's current position. Each plant takes about 3 kB of JSON.
//
// Fails if the stream fails (a full disk), a coordinate is not finite, or the file would exceed
// glTF's limit of 4 GiB. The limit is checked first before anything is written, as far as the size
// is known from meshes in memory or can be estimated from the first plant. It is checked again
// before each plant, or, if plants are compressed, while writing them.
Result<GlbSummary> write_glb(std::ostream& out, std::span<PlacedMesh const> plants,
                             GlbOptions const& options = {});

// Returns the size of a mesh in a .glb file, without JSON and textures. If the mesh is compressed
// the size is an estimate.
std::uint64_t glb_bytes(mesh::Mesh const& mesh, GlbOptions const& options = {});

} // namespace tractus::exports
