#pragma once

#include "engine/export/piece_encoder.h"
#include "engine/export/wind_channels.h"

#include <span>

namespace tractus::exports {

// Compresses the streams of a piece that encode_triangles() and encode_wind() have filled, each by
// its format's codec. Its indices have 32 bits and count from its own first vertex.
void compress_triangles(SurfaceFormat const& format, std::span<WindStream const> wind,
                        EncodedPiece& piece);

// Compresses what encode_instances() and encode_wind() have filled.
void compress_instances(InstanceFormat const& format, EncodedPiece& piece);

} // namespace tractus::exports
