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

// The elements of one accessor: their format and number, and the block of the binary chunk that has
// space for them.
struct GlbColumn {
    NumberFormat format {};
    std::size_t count = 0;
    GlbStream::Block block {};
    // Only for a compressed block: offset of its decompressed elements in the fallback buffer,
    // which is declared but not stored.
    std::optional<std::uint64_t> decompressed_start {};

    std::uint64_t element_bytes() const { return static_cast<std::uint64_t>(format.element_bytes); }
};

// Reserves space for `count` elements at the end of the binary chunk.
GlbColumn open_column(GlbStream& stream, NumberFormat const& format, std::size_t count);

// Reserves `compressed_bytes` at the end of the binary chunk, for `count` elements that the codec
// of `format` has compressed to that size.
GlbColumn open_compressed_column(GlbStream& stream, GltfJson& json, NumberFormat const& format,
                                 std::size_t count, std::size_t compressed_bytes);

// Adds a buffer view of the block to the JSON, with the additional members in `more`. Returns the
// view's index.
std::size_t add_view(GltfJson& json, GlbStream::Block const& block,
                     Json const& more = Json::object());

// Adds the column's buffer view and accessor to the JSON. The accessor gets the additional members
// in `more`. Returns the accessor's index.
std::size_t add_accessor(GltfJson& json, GlbColumn const& column, int target,
                         Json const& more = Json::object());

// Adds an accessor whose elements are zero, which takes no space in the binary chunk (glTF 2.0
// section 3.6.2.3). Returns its index.
std::size_t add_zeros(GltfJson& json, NumberFormat const& format, std::size_t count,
                      Json const& more = Json::object());

// Returns the members "min" and "max" that an accessor of positions must have, for the parameter
// `more` of add_accessor().
Json limits_json(Vec3f const& low, Vec3f const& high);

// Number of the columns for triangles: positions, normals, texture coordinates, indices, and
// tangents, which may be empty. Columns for other data may follow.
constexpr std::size_t kTriangleColumns = 5;

// Adds the accessors of the first kTriangleColumns of `columns`; `limits` has the limits of the
// positions. Returns the glTF primitive, without its material.
Json add_triangles(GltfJson& json, std::span<GlbColumn const> columns, EncodedPiece const& limits);

} // namespace tractus::exports
