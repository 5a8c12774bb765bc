#pragma once

#include "engine/export/glb_writer.h"
#include "engine/export/gltf_json.h"
#include "engine/export/piece_encoder.h"
#include "engine/mesh/wind.h"

#include <span>
#include <string_view>

namespace tractus::exports {

// The first of a piece's streams that are for the wind.
constexpr std::size_t kFirstWindStream = 5;

// One attribute of a mesh or of instances.
struct WindStream {
    std::string_view name;
    NumberFormat format {};
};

// The streams that GlbOptions::Wind asks for, in their order: at most kMostStreams -
// kFirstWindStream.
std::span<WindStream const> wind_streams(GlbOptions::Wind channels);

// Fills those streams of `piece`; leaves them empty where there is no wind.
void encode_wind(std::span<mesh::WindVertex const> wind, GlbOptions::Wind channels,
                 EncodedPiece& piece);

// Returns what Attributes says, as the extras of a node.
Json wind_extras(mesh::WindVertex const& wind);

} // namespace tractus::exports
