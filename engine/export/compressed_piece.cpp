#include "engine/export/compressed_piece.h"

#include "engine/export/attribute_codec.h"
#include "engine/export/mesh_codec.h"

namespace tractus::exports {
namespace {

void compress_stream(NumberFormat const& format, std::size_t stream, EncodedPiece& piece)
{
    auto const& from = piece.streams[stream];
    if (from.empty())
        return;
    auto& to = piece.compressed[stream];
    if (format.codec == Codec::Indices)
        compress_indices({ reinterpret_cast<std::uint32_t const*>(from.data()), from.size() / 4 },
                         to);
    else
        compress_attributes(from, static_cast<std::size_t>(format.element_bytes), to);
    piece.streams[stream] = to;
}

void compress_wind(std::span<WindStream const> wind, EncodedPiece& piece)
{
    for (std::size_t i = 0; i < wind.size(); ++i)
        compress_stream(wind[i].format, kFirstWindStream + i, piece);
}

} // namespace

void compress_triangles(SurfaceFormat const& format, std::span<WindStream const> wind,
                        EncodedPiece& piece)
{
    compress_stream(format.positions(), 0, piece);
    compress_stream(format.normals(), 1, piece);
    compress_stream(format.texture_coordinates(), 2, piece);
    compress_stream(format.indices(), 3, piece);
    compress_stream(format.tangent_vectors(), 4, piece);
    compress_wind(wind, piece);
}

void compress_instances(InstanceFormat const& format, EncodedPiece& piece)
{
    compress_stream(InstanceFormat::translations(), 0, piece);
    compress_stream(format.rotations(), 1, piece);
    compress_stream(InstanceFormat::scales(), 2, piece);
    compress_wind(wind_streams(GlbOptions::Wind::Attributes), piece);
}

} // namespace tractus::exports
