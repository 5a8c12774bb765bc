#include "engine/export/wind_channels.h"

#include "engine/export/gltf_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus::exports {

namespace {

constexpr NumberFormat kScalar { ComponentType::Float, 1, false, 4 };
constexpr NumberFormat kPair { ComponentType::Float, 2, false, 8 };
constexpr NumberFormat kVector {};
constexpr NumberFormat kColour { ComponentType::UnsignedByte, 4, true, 4 };
// Branching level that is stored as the maximum of its colour channel.
constexpr float kMaxLevels = 8;

constexpr std::array<WindStream, 5> kAttributes { { { "_PIVOT", kVector },
                                                    { "_AXIS", kVector },
                                                    { "_LEVEL", kScalar },
                                                    { "_PHASE", kScalar },
                                                    { "_BEND", kScalar } } };
constexpr std::array<WindStream, 4> kTextureCoordinates { { { "TEXCOORD_1", kPair },
                                                            { "TEXCOORD_2", kPair },
                                                            { "TEXCOORD_3", kPair },
                                                            { "TEXCOORD_4", kPair } } };
constexpr std::array<WindStream, 1> kColours { { { "COLOR_0", kColour } } };

// Fills one wind stream of a piece. values(vertex) returns the data of a vertex as an Eigen vector.
template<typename Values>
void fill_stream(std::span<mesh::WindVertex const> wind, std::size_t stream, EncodedPiece& piece,
                 Values const& values)
{
    using Value = decltype(values(mesh::WindVertex()));
    using Scalar = typename Value::Scalar;
    auto& storage = piece.storage[kFirstWindStream + stream];
    storage.resize(wind.size() * sizeof(Scalar) * Value::SizeAtCompileTime);
    auto* to = reinterpret_cast<Scalar*>(storage.data());
    for (auto const& vertex : wind) {
        Value const value = values(vertex);
        to = std::copy_n(value.data(), Value::SizeAtCompileTime, to);
    }
    piece.streams[kFirstWindStream + stream] = storage;
}

using Vec1f = Eigen::Matrix<float, 1, 1>;
using Bytes4 = Eigen::Matrix<std::uint8_t, 4, 1>;

void encode_attributes(std::span<mesh::WindVertex const> wind, EncodedPiece& piece)
{
    fill_stream(wind, 0, piece,
                [](mesh::WindVertex const& v) -> Vec3f { return to_gltf(v.pivot_mm); });
    fill_stream(wind, 1, piece,
                [](mesh::WindVertex const& v) -> Vec3f { return turn_to_gltf(v.axis); });
    fill_stream(wind, 2, piece, [](mesh::WindVertex const& v) { return Vec1f(v.level); });
    fill_stream(wind, 3, piece, [](mesh::WindVertex const& v) { return Vec1f(v.phase); });
    fill_stream(wind, 4, piece, [](mesh::WindVertex const& v) { return Vec1f(v.bend); });
}

void encode_texture_coordinates(std::span<mesh::WindVertex const> wind, EncodedPiece& piece)
{
    fill_stream(wind, 0, piece,
                [](mesh::WindVertex const& v) -> Vec2f { return to_gltf(v.pivot_mm).head<2>(); });
    fill_stream(wind, 1, piece,
                [](mesh::WindVertex const& v) { return Vec2f(to_gltf(v.pivot_mm).z(), v.bend); });
    fill_stream(wind, 2, piece,
                [](mesh::WindVertex const& v) -> Vec2f { return turn_to_gltf(v.axis).head<2>(); });
    fill_stream(wind, 3, piece, [](mesh::WindVertex const& v) {
        return Vec2f(turn_to_gltf(v.axis).z(), v.level + v.phase);
    });
}

void encode_colours(std::span<mesh::WindVertex const> wind, EncodedPiece& piece)
{
    auto const byte = [](float share) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0f, 1.0f)));
    };
    fill_stream(wind, 0, piece, [&](mesh::WindVertex const& v) {
        return Bytes4(byte(v.phase), byte(v.bend), byte(v.level / kMaxLevels), 255);
    });
}

} // namespace

std::span<WindStream const> wind_streams(GlbOptions::Wind channels)
{
    switch (channels) {
    case GlbOptions::Wind::TextureCoordinates:
        return kTextureCoordinates;
    case GlbOptions::Wind::Colours:
        return kColours;
    case GlbOptions::Wind::Attributes:
        break;
    }
    return kAttributes;
}

void encode_wind(std::span<mesh::WindVertex const> wind, GlbOptions::Wind channels,
                 EncodedPiece& piece)
{
    for (std::size_t i = kFirstWindStream; i < kMaxStreams; ++i)
        piece.streams[i] = {};
    if (wind.empty())
        return;
    switch (channels) {
    case GlbOptions::Wind::Attributes:
        return encode_attributes(wind, piece);
    case GlbOptions::Wind::TextureCoordinates:
        return encode_texture_coordinates(wind, piece);
    case GlbOptions::Wind::Colours:
        return encode_colours(wind, piece);
    }
}

Json wind_extras(mesh::WindVertex const& wind)
{
    return { { "_PIVOT", json_numbers(to_gltf(wind.pivot_mm)) },
             { "_AXIS", json_numbers(turn_to_gltf(wind.axis)) },
             { "_LEVEL", json_number(wind.level) },
             { "_PHASE", json_number(wind.phase) },
             { "_BEND", json_number(wind.bend) } };
}

} // namespace tractus::exports
