#pragma once

#include "engine/base/result.h"
#include "engine/export/placed_mesh.h"

#include <cstdint>
#include <functional>
#include <ostream>
#include <span>

namespace tractus::exports {

// Size limit of a file: its length is a number of 32 bits (glTF 2.0 section 4.4.2).
constexpr std::uint64_t kMaxGlbBytes = 0xFFFFFFFF;

struct GlbSummary {
    std::uint64_t bytes = 0;     // Size of the whole file.
    std::uint64_t triangles = 0; // As drawn: every instance counted, the finest level only.
    // About what the file would take with Vertices::Compressed; before_writing() is told, nobody
    // else.
    std::uint64_t compressed_bytes = 0;
};

struct GlbOptions {
    // How the copies of an organ, such as leaves, are written.
    enum class Organs {
        Merged,    // Part of the plant's mesh, one primitive per material: every program opens it.
        Instanced, // EXT_mesh_gpu_instancing, which a reader must then know: small and fast.
        Nodes,     // A node per organ: every reader knows it, many are slow with so many.
    };
    // Whether pictures of bark and of a leaf's veins are put into the file.
    enum class Textures {
        Embedded,
        None,
    };

    // How precise the vertices of tubes and polygons are.
    enum class Vertices {
        Float,     // 32 bytes each.
        Quantized, // KHR_mesh_quantization, which a reader must then know: 20 bytes each. Positions
                   // are rounded to 1/65,532 of the plant's size, normals to 8 bits, and rotations
                   // of organs to 16.
        Compressed, // Quantized, and compressed by EXT_meshopt_compression, which a reader must
                    // then know, too: about 13 bytes each with their triangles. Directions are
                    // rounded to 1.3 degrees, texture coordinates to 1/4096.
    };

    // Where vertices keep what the wind needs, of plants that have it; those of merged organs, too.
    // Organs that are instanced always have it as attributes; those that are nodes, under the same
    // names in their extras.
    //
    // Attributes:         _PIVOT and _AXIS (x, y, z), _LEVEL, _PHASE and _BEND.
    // TextureCoordinates: TEXCOORD_1 (pivot x, y), _2 (pivot z, bend), _3 (axis x, y), _4 (axis z,
    //                     level + phase).
    // Colours:            COLOR_0, 8 bits each: phase, bend, level / 8 (1 at most), 1.
    //
    // Pivots are in metres in the frame of the plant's node, +y up, and so are axes, whatever
    // `vertices` says.
    enum class Wind { Attributes, TextureCoordinates, Colours };
    Wind wind = Wind::Attributes;

    Organs organs = Organs::Merged;
    Textures textures = Textures::Embedded;
    Vertices vertices = Vertices::Float;

    // Is told, before anything is written, what the file will hold about: as if the first plant
    // were like the others, and JSON and textures not counted.
    std::function<void(GlbSummary const& expected)> before_writing {};
};

// Writes plants as one binary glTF 2.0 file: metres, +y up, a node and a mesh per plant, which has
// a primitive for each material (several if it is compressed), organs as the options say.
// Materials, prototypes and textures that are equal are there once. Levels of detail are
// MSFT_lod's: nodes of their own, with the least shares of the screen's area in the plant's extras
// (MSFT_screencoverage). Same input, same bytes.
//
// Plants are written one after another, each in pieces: while one piece is written others are made
// on other threads. A plant given as PlantToMesh is meshed in those pieces, so that memory holds
// two or three plants and a few megabytes. The JSON part, which comes first in the file, is filled
// in at the end: so `out` must be binary and seekable (a file, or a std::ostringstream); the file
// begins where it stands. Each plant takes about 3 kB of JSON.
//
// Fails if the stream fails (a full disk), if a coordinate is not finite, and if the file would
// pass glTF's limit of 4 GiB: before anything is written when that is certain from plants that are
// given, or likely from the first one; otherwise before the plant that would pass it, or in the
// midst of it if it is compressed.
Result<GlbSummary> write_glb(std::ostream& out, std::span<PlacedMesh const> plants,
                             GlbOptions const& options = {});

// Bytes that a mesh will take in such a file, JSON and textures not counted; about as many if it is
// compressed.
std::uint64_t glb_bytes(mesh::Mesh const& mesh, GlbOptions const& options = {});

} // namespace tractus::exports
