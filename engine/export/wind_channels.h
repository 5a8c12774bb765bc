#pragma once

#include "engine/export/glb_writer.h"
#include "engine/export/gltf_json.h"
#include "engine/export/piece_encoder.h"
#include "engine/mesh/wind.h"

#include <span>
#include <string_view>

namespace tractus::exports {

// Index, among the streams of a piece, of the first stream with wind data.
constexpr std::size_t kFirstWindStream = 5;

// One wind attribute of a mesh or of instances.
struct WindStream {
    std::string_view name;
    NumberFormat format {};
};

// Returns the streams that a value of GlbOptions::Wind requires, in the order of the piece's
// streams; at most kMaxStreams - kFirstWindStream.
std::span<WindStream const> wind_streams(GlbOptions::Wind channels);

// Fills the wind streams of `piece`; empties them if `wind` is empty.
void encode_wind(std::span<mesh::WindVertex const> wind, GlbOptions::Wind channels,
                 EncodedPiece& piece);

// Returns wind data as the extras of a node, under the names of Wind::Attributes.
Json wind_extras(mesh::WindVertex const& wind);

} // namespace tractus::exports
