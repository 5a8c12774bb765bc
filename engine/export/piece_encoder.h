#pragma once

#include "engine/base/bulk_vector.h"
#include "engine/export/mesh_pieces.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::exports {

// Number types of glTF (glTF 2.0 section 3.6.2.2).
enum class ComponentType {
    Byte = 5120,
    UnsignedByte = 5121,
    Short = 5122,
    UnsignedShort = 5123,
    UnsignedInt = 5125,
    Float = 5126
};

// Compression of numbers by EXT_meshopt_compression: mode ATTRIBUTES without a filter or with one,
// or mode INDICES.
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
    // True: 16-bit positions and 8-bit normals, as KHR_mesh_quantization allows; false: floats.
    bool quantized = false;
    // True if normals, tangents and texture coordinates are encoded for the filters of
    // EXT_meshopt_compression; only if quantized.
    bool filtered = false;
    // In metres, glTF's frame: a quantised position is origin_m + step_m * number. The step is the
    // same for all components, so that normals are unaffected.
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

// Returns the quantisation for positions within a box; also valid for an empty or infinite box.
SurfaceFormat quantized_format(Bounds const& bounds_mm);

constexpr std::size_t kMaxStreams = 10;

// An encoded part of a file: each stream is appended to a block of its own.
struct EncodedPiece {
    std::array<std::span<std::byte const>, kMaxStreams> streams {};
    bool is_finite = true;
    // Numbers of vertices and indices; instances count as vertices.
    mesh::MeshExtent extent {};
    // Limits of the positions as written; low is above high if there are no positions.
    Vec3f low = Vec3f::Constant(std::numeric_limits<float>::infinity());
    Vec3f high = -low;

    // Memory of the streams, unless they refer to the mesh itself.
    std::array<BulkVector<std::byte>, kMaxStreams> storage {};
    std::array<BulkVector<std::byte>, kMaxStreams> compressed {};
};

// Encodes triangles into the streams positions, normals, texture coordinates, indices, tangents.
// `triangles` must outlive the result; `piece` may be reused.
void encode_triangles(TriangleView const& triangles, SurfaceFormat const& format,
                      EncodedPiece& piece);

// Number formats for the transforms of organs: translations, rotations, scales.
struct InstanceFormat {
    bool quantized = false; // True: 16-bit rotations, as EXT_mesh_gpu_instancing permits.

    static NumberFormat translations();
    NumberFormat rotations() const;
    static NumberFormat scales();
};

// Encodes instances into the streams translations, rotations, scales.
void encode_instances(std::span<mesh::InstanceTransform const> instances,
                      InstanceFormat const& format, EncodedPiece& piece);

} // namespace tractus::exports
