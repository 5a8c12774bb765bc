#pragma once

#include "engine/base/result.h"
#include "engine/export/placed_mesh.h"

#include <cstdint>
#include <ostream>
#include <span>

namespace tractus {

struct GlbOptions {
    // How the copies of an organ are written.
    enum class Instancing {
        Extension, // EXT_mesh_gpu_instancing, which a reader must then know: small and fast.
        Nodes,     // A node per organ: larger, and every reader knows it.
    };
    // Whether pictures of bark and of a leaf's veins are put into the file.
    enum class Textures {
        Embedded,
        None,
    };

    Instancing instancing = Instancing::Extension;
    Textures textures = Textures::Embedded;
};

struct GlbSummary {
    std::uint64_t bytes = 0;     // Of the whole file.
    std::uint64_t triangles = 0; // As drawn: every instance counted.
};

// Writes plants as one binary glTF 2.0 file: metres, +y up, a node per plant with its tubes and
// polygons, and the organs as instances of shared prototypes. Materials, prototypes and textures
// that are equal are there once. Same input, same bytes.
//
// Plants are written one after another, and the JSON part, which comes first in the file, is filled
// in at the end: so `out` must be binary and seekable (a file, or a std::ostringstream); the file
// begins where it stands. Memory is bounded by one plant and about 3 kB of JSON for each.
//
// Fails if the stream fails (a full disk), if a coordinate is not finite, and if the file would
// pass glTF's limit of 4 GiB: before anything is written when all plants are given as meshes,
// otherwise before the plant that would pass it.
Result<GlbSummary> write_glb(std::ostream& out, std::span<PlacedMesh const> plants,
                             GlbOptions const& options = {});

// Bytes that a mesh will take in such a file, its JSON not counted.
std::uint64_t glb_bytes(Mesh const& mesh);

} // namespace tractus
