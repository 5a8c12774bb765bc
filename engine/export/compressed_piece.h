#pragma once

#include "engine/export/piece_encoder.h"
#include "engine/export/wind_channels.h"

#include <span>

namespace tractus::exports {

// Compresses the streams that encode_triangles() and encode_wind() wrote to `piece`, each with the
// codec of its format. The indices must have 32 bits and count from the piece's first vertex.
void compress_triangles(SurfaceFormat const& format, std::span<WindStream const> wind,
                        EncodedPiece& piece);

// Compresses the streams that encode_instances() and encode_wind() wrote to `piece`.
void compress_instances(InstanceFormat const& format, EncodedPiece& piece);

} // namespace tractus::exports
