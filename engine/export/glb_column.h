#pragma once

#include "engine/export/glb_stream.h"
#include "engine/export/gltf_json.h"
#include "engine/export/piece_encoder.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace tractus {

// What a buffer view is for (glTF 2.0 section 5.11.5).
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kNoTarget = 0;

// A block whose elements an accessor will describe.
struct GlbColumn {
    NumberFormat format {};
    std::size_t count = 0;
    GlbStream::Block block {};
};

// Makes room at the end of the binary chunk.
GlbColumn open_column(GlbStream& stream, NumberFormat const& format, std::size_t count);

// Adds the column's buffer view and accessor; `more` is added to the accessor's text. Answers the
// accessor's index.
std::size_t add_accessor(GltfJson& json, GlbColumn const& column, int target,
                         std::string_view more = {});

// The same for zeros, which take no bytes (section 3.6.2.3).
std::size_t add_zeros(GltfJson& json, NumberFormat const& format, std::size_t count,
                      std::string_view more = {});

// What an accessor of positions says of them, to be given as `more`.
std::string limits_text(Vec3f const& low, Vec3f const& high);

} // namespace tractus
