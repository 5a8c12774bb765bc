#pragma once

#include "engine/base/bulk_vector.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace tractus::exports {

// The codecs of glTF's extension EXT_meshopt_compression from meshoptimizer, except for the encoder
// in attribute_codec.h. Thread-safe.

enum class CodecMode { Attributes, Triangles, Indices };
enum class CodecFilter { None, Octahedral, Quaternion, Exponential };

// Compresses indices by mode INDICES, replacing the contents of `to`. Mode TRIANGLES takes six
// times as long for the triangle order of tubes, and is no smaller.
void compress_indices(std::span<std::uint32_t const> indices, BulkVector<std::byte>& to);

// A block of compressed elements in a file: its codec, dimensions and bytes.
struct CompressedElements {
    CodecMode mode = CodecMode::Attributes;
    CodecFilter filter = CodecFilter::None;
    std::uint64_t count = 0;
    std::uint64_t stride = 0; // Size of an element in bytes.
    std::span<std::byte const> bytes {};
};

// Returns a reason why elements of these dimensions cannot be decompressed, regardless of their
// bytes, as the end of a sentence. Returns null if there is none: then the decompressed size is at
// most 64 times the compressed size.
char const* find_flaw(CompressedElements const& elements);

// Decompresses elements for which find_flaw() is null into `to`, of count * stride bytes. Safe for
// arbitrary bytes. Returns false if they are damaged.
bool decompress(CompressedElements const& elements, std::span<std::byte> to);

} // namespace tractus::exports
