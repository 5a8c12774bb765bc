#pragma once

#include "engine/base/bulk_vector.h"
#include "engine/export/mesh_pieces.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::exports {

// Component types of accessors (glTF 2.0 section 3.6.2.2).
enum class ComponentType {
    Byte = 5120,
    UnsignedByte = 5121,
    Short = 5122,
    UnsignedShort = 5123,
    UnsignedInt = 5125,
    Float = 5126
};

// How numbers are compressed by EXT_meshopt_compression: by mode ATTRIBUTES without a filter, with
// the filter OCTAHEDRAL or EXPONENTIAL, or by mode INDICES.
enum class Codec { Attributes, Octahedral, Exponential, Indices };

// Number format of an accessor.
struct NumberFormat {
    ComponentType type = ComponentType::Float;
    int components = 3;
    bool normalized = false;
    int element_bytes = 12; // Size of an element; a multiple of four, except for indices.
    Codec codec = Codec::Attributes;
};

// Number formats of a surface's vertices.
struct SurfaceFormat {
    // True: positions have 16 bits and normals 8 bits, as KHR_mesh_quantization allows. False: both
    // are floats.
    bool quantized = false;
    // True if normals, tangents and texture coordinates are encoded for the filters of
    // EXT_meshopt_compression. Only if `quantized`.
    bool filtered = false;
    // Scale of quantised positions: the number n stands for origin_m + step_m * n (metres, glTF's
    // frame). The step is the same for all components, so that normals are unaffected.
    Vec3 origin_m = Vec3::Zero();
    double step_m = 1;
    bool short_indices = false; // True: indices have 16 bits, otherwise 32.
    bool tangents = false;      // True: vertices have tangents, for a normal map.

    NumberFormat positions() const;
    NumberFormat normals() const;
    NumberFormat tangent_vectors() const;
    NumberFormat texture_coordinates() const;
    NumberFormat indices() const;
};

// Returns the format for quantised positions within a box. For an empty or infinite box it is a
// valid format with default scale.
SurfaceFormat quantized_format(Bounds const& bounds_mm);

constexpr std::size_t kMaxStreams = 10;

// An encoded part of a plant. Each stream is to be appended to a block of its own in the file.
struct EncodedPiece {
    std::array<std::span<std::byte const>, kMaxStreams> streams {};
    bool is_finite = true;
    // Numbers of vertices and indices; instances count as vertices.
    mesh::MeshExtent extent {};
    // Limits of the positions, in the numbers that are written. `low` is above `high` if there are
    // no positions.
    Vec3f low = Vec3f::Constant(std::numeric_limits<float>::infinity());
    Vec3f high = -low;

    // Memory of the streams that do not refer to the mesh itself: encoded, and encoded and
    // compressed.
    std::array<BulkVector<std::byte>, kMaxStreams> storage {};
    std::array<BulkVector<std::byte>, kMaxStreams> compressed {};
};

// Encodes triangles into the first five streams of `piece`: positions, normals, texture
// coordinates, indices, tangents. The arrays of `triangles` must outlive the result; `piece` may
// have been used before.
void encode_triangles(TriangleView const& triangles, SurfaceFormat const& format,
                      EncodedPiece& piece);

// Number formats for the transforms of organs, which are translations, rotations and scales.
struct InstanceFormat {
    bool quantized = false; // True: 16-bit rotations, as EXT_mesh_gpu_instancing permits.

    static NumberFormat translations();
    NumberFormat rotations() const;
    static NumberFormat scales();
};

// Encodes instances into the first three streams of `piece`: translations, rotations, scales.
void encode_instances(std::span<mesh::InstanceTransform const> instances,
                      InstanceFormat const& format, EncodedPiece& piece);

} // namespace tractus::exports
