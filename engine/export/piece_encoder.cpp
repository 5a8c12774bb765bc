#include "engine/export/piece_encoder.h"

#include "engine/export/codec_filters.h"
#include "engine/export/gltf_frame.h"
#include "engine/export/turned_vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace tractus::exports {
namespace {

constexpr float kMaxByte = 127;
constexpr float kMaxShort = 32767;

// Allocates memory for `count` values in one of a piece's streams.
template<typename Value> Value* room_for(EncodedPiece& piece, std::size_t stream, std::size_t count)
{
    auto& storage = piece.storage[stream];
    storage.resize(count * sizeof(Value));
    piece.streams[stream] = storage;
    return reinterpret_cast<Value*>(storage.data());
}

void encode_positions(std::span<Vec3f const> positions_mm, EncodedPiece& piece)
{
    auto* to = room_for<float>(piece, 0, 3 * positions_mm.size());
    Vec3f low = piece.low;
    Vec3f high = piece.high;
    // Sum of x - x over all coordinates x: 0 if all are finite, otherwise NaN.
    Vec3f nothing = Vec3f::Zero();
    for (auto const& position : positions_mm) {
        Vec3f const moved = to_gltf(position);
        low = low.cwiseMin(moved);
        high = high.cwiseMax(moved);
        nothing += moved - moved;
        to[0] = moved.x();
        to[1] = moved.y();
        to[2] = moved.z();
        to += 3;
    }
    piece.low = low;
    piece.high = high;
    piece.is_finite = nothing.allFinite();
}

void encode_normals(std::span<Vec3f const> normals, EncodedPiece& piece)
{
    auto* to = room_for<float>(piece, 1, 3 * normals.size());
    for (auto const& normal : normals) {
        Vec3f const turned = turn_to_gltf(normal);
        to[0] = turned.x();
        to[1] = turned.y();
        to[2] = turned.z();
        to += 3;
    }
}

// Rounds to the nearest integer, halves away from zero. Unlike std::round() it can be inlined.
std::int32_t rounded(float value)
{
    return static_cast<std::int32_t>(value + std::copysign(0.5f, value));
}

// Quantises one component of positions (x, y or z) to 16 bits.
class ShortComponent {
public:
    ShortComponent(float origin_mm, float per_mm)
        : origin_mm_(origin_mm)
        , per_mm_(per_mm)
    {
    }

    FourInts encode(FourFloats const& positions_mm)
    {
        FourFloats const scaled = (positions_mm - origin_mm_) * per_mm_;
        nothing_ += scaled - scaled;
        auto const number = bounded(scaled, kMaxShort);
        low_ = number < low_ ? number : low_;
        high_ = number > high_ ? number : high_;
        return round_to_integer_bits(number) & 0xFFFF;
    }

    // low() and high(): the least and the greatest number encoded so far.
    float low() const { return std::nearbyint(std::min({ low_[0], low_[1], low_[2], low_[3] })); }
    float high() const
    {
        return std::nearbyint(std::max({ high_[0], high_[1], high_[2], high_[3] }));
    }
    bool is_finite() const { return nothing_[0] + nothing_[1] + nothing_[2] + nothing_[3] == 0; }

private:
    float origin_mm_;
    float per_mm_;
    FourFloats low_ = FourFloats {} + kMaxShort;
    FourFloats high_ = FourFloats {} - kMaxShort;
    // Sum of x - x over all scaled coordinates x: 0 if all are finite, otherwise NaN.
    FourFloats nothing_ {};
};

void encode_short_positions(std::span<Vec3f const> positions_mm, SurfaceFormat const& format,
                            EncodedPiece& piece)
{
    auto* const to = room_for<std::int16_t>(piece, 0, 4 * positions_mm.size());
    if (positions_mm.empty())
        return;
    Vec3f const origin_mm = (1000 * format.origin_m).cast<float>();
    auto const per_mm = static_cast<float>(0.001 / format.step_m);
    ShortComponent x(origin_mm.x(), per_mm);
    ShortComponent y(origin_mm.y(), per_mm);
    ShortComponent z(origin_mm.z(), per_mm);
    for_each_four(positions_mm, [&](Vec3f const* from, std::size_t first, std::size_t count) {
        auto const position_mm = turned_vectors(from);
        FourInts const xy = x.encode(position_mm.x) | y.encode(position_mm.y) << 16;
        FourInts const z0 = z.encode(position_mm.z);
        std::array<FourInts, 2> const four { __builtin_shufflevector(xy, z0, 0, 4, 1, 5),
                                             __builtin_shufflevector(xy, z0, 2, 6, 3, 7) };
        std::memcpy(to + 4 * first, &four, 8 * count);
    });
    piece.low = { x.low(), y.low(), z.low() };
    piece.high = { x.high(), y.high(), z.high() };
    piece.is_finite = x.is_finite() && y.is_finite() && z.is_finite();
}

void encode_byte_normals(std::span<Vec3f const> normals, EncodedPiece& piece)
{
    auto* const to = room_for<std::int8_t>(piece, 1, 4 * normals.size());
    auto const encode = [](FourFloats const& components) -> FourInts {
        return round_to_integer_bits(bounded(components * kMaxByte, kMaxByte)) & 0xFF;
    };
    for_each_four(normals, [&](Vec3f const* from, std::size_t first, std::size_t count) {
        auto const n = turned_vectors(from);
        FourInts const four = encode(n.x) | encode(n.y) << 8 | encode(n.z) << 16;
        std::memcpy(to + 4 * first, &four, 4 * count);
    });
}

void encode_tangents(std::span<Eigen::Vector4f const> tangents, SurfaceFormat const& format,
                     EncodedPiece& piece)
{
    constexpr std::size_t kStream = 4;
    auto const encode = [&]<typename Number>(Number* to, auto const& number) {
        for (auto const& tangent : tangents) {
            Vec3f const turned = turn_to_gltf(Vec3f(tangent.head<3>()));
            for (int k = 0; k < 3; ++k)
                *to++ = number(turned[k]);
            *to++ = number(tangent.w());
        }
    };
    if (format.quantized)
        encode(room_for<std::int8_t>(piece, kStream, 4 * tangents.size()), [](float value) {
            return static_cast<std::int8_t>(rounded(kMaxByte * std::clamp(value, -1.0f, 1.0f)));
        });
    else
        encode(room_for<float>(piece, kStream, 4 * tangents.size()),
               [](float value) { return value; });
}

Codec filtered_by(SurfaceFormat const& format, Codec codec)
{
    return format.filtered ? codec : Codec::Attributes;
}

// Encodes normals, texture coordinates and tangents for the filters of EXT_meshopt_compression.
// Indices keep 32 bits, as their codec requires.
void encode_filtered(TriangleView const& triangles, SurfaceFormat const& format,
                     EncodedPiece& piece)
{
    auto const& pairs = triangles.texture_coordinates;
    encode_octahedral(triangles.normals,
                      room_for<std::int8_t>(piece, 1, 4 * triangles.normals.size()));
    encode_exponential({ pairs.empty() ? nullptr : pairs.front().data(), 2 * pairs.size() },
                       room_for<std::uint32_t>(piece, 2, 2 * pairs.size()));
    if (format.tangents)
        encode_octahedral(triangles.tangents,
                          room_for<std::int8_t>(piece, 4, 4 * triangles.tangents.size()));
}

} // namespace

NumberFormat SurfaceFormat::positions() const
{
    return quantized ? NumberFormat { ComponentType::Short, 3, false, 8 } : NumberFormat {};
}

NumberFormat SurfaceFormat::normals() const
{
    return quantized
        ? NumberFormat { ComponentType::Byte, 3, true, 4, filtered_by(*this, Codec::Octahedral) }
        : NumberFormat {};
}

NumberFormat SurfaceFormat::tangent_vectors() const
{
    return quantized
        ? NumberFormat { ComponentType::Byte, 4, true, 4, filtered_by(*this, Codec::Octahedral) }
        : NumberFormat { ComponentType::Float, 4, false, 16 };
}

NumberFormat SurfaceFormat::texture_coordinates() const
{
    return { ComponentType::Float, 2, false, 8, filtered_by(*this, Codec::Exponential) };
}

NumberFormat SurfaceFormat::indices() const
{
    return short_indices
        ? NumberFormat { ComponentType::UnsignedShort, 1, false, 2, Codec::Indices }
        : NumberFormat { ComponentType::UnsignedInt, 1, false, 4, Codec::Indices };
}

SurfaceFormat quantized_format(Bounds const& bounds_mm)
{
    SurfaceFormat format { .quantized = true };
    Vec3 const size_mm = bounds_mm.max_mm - bounds_mm.min_mm;
    if (bounds_mm.empty() || !size_mm.allFinite() || !(size_mm.maxCoeff() > 0))
        return format;
    Vec3 const center_mm = 0.5 * (bounds_mm.min_mm + bounds_mm.max_mm);
    // The origin is rounded to float, because vertices are encoded relative to a float origin.
    format.origin_m = to_gltf(center_mm).cast<float>().cast<double>();
    // The step is slightly larger than the size requires, so that rounding stays within 16 bits.
    format.step_m = 0.001 * size_mm.maxCoeff() / (2 * (double { kMaxShort } - 1));
    return format;
}

void encode_triangles(TriangleView const& triangles, SurfaceFormat const& format,
                      EncodedPiece& piece)
{
    piece.low = Vec3f::Constant(std::numeric_limits<float>::infinity());
    piece.high = -piece.low;
    piece.extent = { triangles.positions_mm.size(), triangles.indices.size() };
    if (format.quantized) {
        encode_short_positions(triangles.positions_mm, format, piece);
        if (!format.filtered)
            encode_byte_normals(triangles.normals, piece);
    } else {
        encode_positions(triangles.positions_mm, piece);
        encode_normals(triangles.normals, piece);
    }
    piece.streams[2] = std::as_bytes(triangles.texture_coordinates);
    piece.streams[3] = std::as_bytes(triangles.indices);
    piece.streams[4] = {};
    if (format.filtered)
        return encode_filtered(triangles, format, piece);
    if (format.tangents)
        encode_tangents(triangles.tangents, format, piece);
    if (!format.short_indices)
        return;
    auto* const to = room_for<std::uint16_t>(piece, 3, triangles.indices.size());
    for (std::size_t i = 0; i < triangles.indices.size(); ++i)
        to[i] = static_cast<std::uint16_t>(triangles.indices[i]);
}

NumberFormat InstanceFormat::translations()
{
    return {};
}

NumberFormat InstanceFormat::rotations() const
{
    return quantized ? NumberFormat { ComponentType::Short, 4, true, 8 }
                     : NumberFormat { ComponentType::Float, 4, false, 16 };
}

NumberFormat InstanceFormat::scales()
{
    return {};
}

void encode_instances(std::span<mesh::InstanceTransform const> instances,
                      InstanceFormat const& format, EncodedPiece& piece)
{
    auto* translation = room_for<float>(piece, 0, 3 * instances.size());
    auto* const rotation = room_for<float>(piece, 1, format.quantized ? 0 : 4 * instances.size());
    auto* const short_rotation
        = format.quantized ? room_for<std::int16_t>(piece, 1, 4 * instances.size()) : nullptr;
    auto* scale = room_for<float>(piece, 2, 3 * instances.size());
    piece.streams[3] = {};
    piece.streams[4] = {};
    piece.extent = { instances.size(), 0 };
    piece.is_finite = true;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        auto const placed = to_gltf(instances[i]);
        piece.is_finite = piece.is_finite && placed.translation_mm.allFinite()
            && placed.rotation.coeffs().allFinite() && placed.scale.allFinite();
        for (int k = 0; k < 3; ++k) {
            *translation++ = placed.translation_mm[k];
            *scale++ = placed.scale[k];
        }
        for (int k = 0; k < 4; ++k) {
            float const value = placed.rotation.coeffs()[k]; // The order is x, y, z, w.
            auto const at = 4 * i + static_cast<std::size_t>(k);
            if (format.quantized)
                short_rotation[at] = static_cast<std::int16_t>(
                    rounded(kMaxShort * std::max(-1.0f, std::min(1.0f, value))));
            else
                rotation[at] = value;
        }
    }
}

} // namespace tractus::exports
