#pragma once

#include "engine/export/glb_stream.h"
#include "engine/export/gltf_json.h"
#include "engine/export/piece_encoder.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace tractus::exports {

// Targets of a buffer view (glTF 2.0 section 5.11.5).
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kNoTarget = 0;

// A block whose elements an accessor will describe.
struct GlbColumn {
    NumberFormat format {};
    std::size_t count = 0;
    GlbStream::Block block {};
    // Where it lies, decompressed, in the buffer that is not there. No value if it is not
    // compressed.
    std::optional<std::uint64_t> decompressed_start {};

    std::uint64_t element_bytes() const { return static_cast<std::uint64_t>(format.element_bytes); }
};

// Makes room at the end of the binary chunk.
GlbColumn open_column(GlbStream& stream, NumberFormat const& format, std::size_t count);

// Likewise for elements that take so many bytes, compressed by their format's codec.
GlbColumn open_compressed_column(GlbStream& stream, GltfJson& json, NumberFormat const& format,
                                 std::size_t count, std::size_t compressed_bytes);

// Adds a buffer view, with the members of `more`. Returns its index.
std::size_t add_view(GltfJson& json, GlbStream::Block const& block,
                     Json const& more = Json::object());

// Adds the column's buffer view and its accessor, with the members of `more`. Returns the
// accessor's index.
std::size_t add_accessor(GltfJson& json, GlbColumn const& column, int target,
                         Json const& more = Json::object());

// Adds an accessor of zeros, which take no bytes (section 3.6.2.3).
std::size_t add_zeros(GltfJson& json, NumberFormat const& format, std::size_t count,
                      Json const& more = Json::object());

// Returns what an accessor of positions says of them, to be given as `more`.
Json limits_json(Vec3f const& low, Vec3f const& high);

// Positions, normals, texture coordinates, indices, and tangents unless they are empty. More may
// follow.
constexpr std::size_t kTriangleColumns = 5;

// Adds the accessors of triangles, whose positions lie within the limits. Returns the primitive,
// but for its material.
Json add_triangles(GltfJson& json, std::span<GlbColumn const> columns, EncodedPiece const& limits);

} // namespace tractus::exports
