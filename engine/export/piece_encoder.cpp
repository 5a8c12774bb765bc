#include "engine/export/piece_encoder.h"

#include "engine/export/gltf_frame.h"

#include <algorithm>
#include <cmath>

namespace tractus {
namespace {

constexpr float kMostByte = 127;
constexpr float kMostShort = 32767;

// Room for `count` values in one of a piece's streams.
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
    Vec3f nothing = Vec3f::Zero(); // x - x is 0, or no number where x is infinite or none.
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

// Rounds half away from zero, which unlike std::round() is no call.
std::int32_t rounded(float value)
{
    return static_cast<std::int32_t>(value + std::copysign(0.5f, value));
}

void encode_short_positions(std::span<Vec3f const> positions_mm, SurfaceFormat const& format,
                            EncodedPiece& piece)
{
    auto* to = room_for<std::int16_t>(piece, 0, 4 * positions_mm.size());
    Vec3f const origin = format.origin_m.cast<float>();
    auto const per_metre = static_cast<float>(1 / format.step_m);
    Vec3f low = piece.low;
    Vec3f high = piece.high;
    Vec3f nothing = Vec3f::Zero();
    for (auto const& position : positions_mm) {
        Vec3f const scaled = (to_gltf(position) - origin) * per_metre;
        nothing += scaled - scaled;
        // The minimum of a number that is none and another is the other: conversions are safe.
        Vec3f whole;
        for (int k = 0; k < 3; ++k) {
            float const bounded = std::max(-kMostShort, std::min(kMostShort, scaled[k]));
            to[k] = static_cast<std::int16_t>(rounded(bounded));
            whole[k] = to[k];
        }
        to[3] = 0;
        to += 4;
        low = low.cwiseMin(whole);
        high = high.cwiseMax(whole);
    }
    piece.low = low;
    piece.high = high;
    piece.is_finite = nothing.allFinite();
}

void encode_byte_normals(std::span<Vec3f const> normals, EncodedPiece& piece)
{
    auto* to = room_for<std::int8_t>(piece, 1, 4 * normals.size());
    for (auto const& normal : normals) {
        Vec3f const turned = turn_to_gltf(normal) * kMostByte;
        for (int k = 0; k < 3; ++k)
            to[k] = static_cast<std::int8_t>(
                rounded(std::max(-kMostByte, std::min(kMostByte, turned[k]))));
        to[3] = 0;
        to += 4;
    }
}

} // namespace

NumberFormat SurfaceFormat::positions() const
{
    return quantized ? NumberFormat { ComponentType::Short, 3, false, 8 } : NumberFormat {};
}

NumberFormat SurfaceFormat::normals() const
{
    return quantized ? NumberFormat { ComponentType::Byte, 3, true, 4 } : NumberFormat {};
}

NumberFormat SurfaceFormat::texture_coordinates()
{
    return { ComponentType::Float, 2, false, 8 };
}

NumberFormat SurfaceFormat::indices() const
{
    return short_indices ? NumberFormat { ComponentType::UnsignedShort, 1, false, 2 }
                         : NumberFormat { ComponentType::UnsignedInt, 1, false, 4 };
}

SurfaceFormat quantized_format(Bounds const& bounds_mm)
{
    SurfaceFormat format { .quantized = true };
    Vec3 const size_mm = bounds_mm.max_mm - bounds_mm.min_mm;
    if (bounds_mm.empty() || !size_mm.allFinite() || !(size_mm.maxCoeff() > 0))
        return format;
    Vec3 const center_mm = 0.5 * (bounds_mm.min_mm + bounds_mm.max_mm);
    format.origin_m = to_gltf(center_mm).cast<float>().cast<double>(); // As it is subtracted.
    // A little more than it takes, so that rounding stays within 16 bits.
    format.step_m = 0.001 * size_mm.maxCoeff() / (2 * (double { kMostShort } - 1));
    return format;
}

void encode_triangles(TriangleView const& triangles, SurfaceFormat const& format,
                      EncodedPiece& piece)
{
    piece.low = Vec3f::Constant(std::numeric_limits<float>::infinity());
    piece.high = -piece.low;
    if (format.quantized) {
        encode_short_positions(triangles.positions_mm, format, piece);
        encode_byte_normals(triangles.normals, piece);
    } else {
        encode_positions(triangles.positions_mm, piece);
        encode_normals(triangles.normals, piece);
    }
    piece.streams[2] = std::as_bytes(triangles.texture_coordinates);
    piece.streams[3] = std::as_bytes(triangles.indices);
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

void encode_instances(std::span<InstanceTransform const> instances, InstanceFormat const& format,
                      EncodedPiece& piece)
{
    auto* translation = room_for<float>(piece, 0, 3 * instances.size());
    auto* const rotation = room_for<float>(piece, 1, format.quantized ? 0 : 4 * instances.size());
    auto* const short_rotation
        = format.quantized ? room_for<std::int16_t>(piece, 1, 4 * instances.size()) : nullptr;
    auto* scale = room_for<float>(piece, 2, 3 * instances.size());
    piece.streams[3] = {};
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
            float const value = placed.rotation.coeffs()[k]; // x, y, z, w.
            auto const at = 4 * i + static_cast<std::size_t>(k);
            if (format.quantized)
                short_rotation[at] = static_cast<std::int16_t>(
                    rounded(kMostShort * std::max(-1.0f, std::min(1.0f, value))));
            else
                rotation[at] = value;
        }
    }
}

} // namespace tractus
