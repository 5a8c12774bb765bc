#pragma once

#include "engine/base/result.h"
#include "engine/export/placed_mesh.h"

#include <cstdint>
#include <functional>
#include <ostream>
#include <span>

namespace tractus::exports {

// Size limit of a file: its length is a 32-bit number (glTF 2.0 section 4.4.2).
constexpr std::uint64_t kMaxGlbBytes = 0xFFFFFFFF;

struct GlbSummary {
    std::uint64_t bytes = 0;     // Size of the whole file.
    std::uint64_t triangles = 0; // Triangles of the finest levels, with those of every instance.
    // Approximate size with Vertices::Compressed; set for before_writing() only.
    std::uint64_t compressed_bytes = 0;
};

struct GlbOptions {
    // How the copies of an organ, such as leaves, are written.
    enum class Organs {
        Merged, // Part of the plant's mesh, one primitive per material: readable by every program.
        Instanced, // As EXT_mesh_gpu_instancing, which the reader must support: small and fast.
        // One node per organ: readable by every program, but slow in many with so many nodes.
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
        // As KHR_mesh_quantization, which the reader must support: 20 bytes per vertex. Positions
        // are rounded to 1/65,532 of the plant's size, normals to 8 bits, and rotations of organs
        // to 16.
        Quantized,
        // Quantized, and compressed by EXT_meshopt_compression, which the reader must also support:
        // about 13 bytes per vertex including triangles. Directions are rounded to 1.3 degrees,
        // texture coordinates to 1/4096.
        Compressed,
    };

    // Where the wind data of vertices are written, for plants that have them; also for merged
    // organs. Instanced organs always have them as attributes; organs that are nodes have them
    // under the same names in their extras.
    //
    // Attributes:         _PIVOT and _AXIS (x, y, z), _LEVEL, _PHASE and _BEND.
    // TextureCoordinates: TEXCOORD_1 (pivot x, y), _2 (pivot z, bend), _3 (axis x, y),
    //                     _4 (axis z, level + phase).
    // Colours:            COLOR_0, 8 bits each: phase, bend, level / 8 (at most 1), 1.
    //
    // Pivots are in metres in the frame of the plant's node, +y up, as are axes, for every value of
    // `vertices`.
    enum class Wind { Attributes, TextureCoordinates, Colours };
    Wind wind = Wind::Attributes;

    Organs organs = Organs::Merged;
    Textures textures = Textures::Embedded;
    Vertices vertices = Vertices::Float;

    // Called with the expected summary before anything is written. It is an estimate as if all
    // plants were like the first, without JSON and textures.
    std::function<void(GlbSummary const& expected)> before_writing {};
};

// Writes plants as one binary glTF 2.0 file: metres, +y up, a node and a mesh per plant with one
// primitive per material (several if compressed), organs according to the options. Equal materials,
// prototypes and textures are written once. Levels of detail use MSFT_lod: separate nodes, with the
// minimum shares of the screen's area in the plant's extras (MSFT_screencoverage). Deterministic.
//
// Plants are written one after another in pieces: while one piece is written, others are made on
// other threads. A plant given as PlantToMesh is meshed in these pieces, so that memory holds only
// two or three plants and a few megabytes. The JSON, which comes first in the file, is filled in at
// the end; `out` must therefore be binary and seekable (a file, or a std::ostringstream). The file
// begins at its current position. Each plant takes about 3 kB of JSON.
//
// Fails if the stream fails (a full disk), a coordinate is not finite, or the file would exceed
// glTF's limit of 4 GiB. The limit is checked before anything is written as far as the size is
// known from the given plants or can be estimated from the first; otherwise before the plant that
// would exceed it, or while writing that plant if it is compressed.
Result<GlbSummary> write_glb(std::ostream& out, std::span<PlacedMesh const> plants,
                             GlbOptions const& options = {});

// Size of a mesh in a .glb file, without JSON and textures; approximate if it is compressed.
std::uint64_t glb_bytes(mesh::Mesh const& mesh, GlbOptions const& options = {});

} // namespace tractus::exports
