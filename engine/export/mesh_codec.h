#pragma once

#include "engine/base/bulk_vector.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace tractus::exports {

// meshoptimizer's codecs for glTF's extension EXT_meshopt_compression. The encoder for mode
// ATTRIBUTES is in attribute_codec.h. All functions are thread-safe.

enum class CodecMode { Attributes, Triangles, Indices };
enum class CodecFilter { None, Octahedral, Quaternion, Exponential };

// Compresses indices by mode INDICES, replacing the contents of `to`. For the triangle order of
// tubes, mode TRIANGLES would take six times as long and save no space.
void compress_indices(std::span<std::uint32_t const> indices, BulkVector<std::byte>& to);

// A block of compressed elements in a file: its codec, dimensions and bytes.
struct CompressedElements {
    CodecMode mode = CodecMode::Attributes;
    CodecFilter filter = CodecFilter::None;
    std::uint64_t count = 0;
    std::uint64_t stride = 0; // Size of an element in bytes.
    std::span<std::byte const> bytes {};
};

// Returns why elements with these dimensions cannot be decompressed, whatever their bytes are, as
// the end of a sentence. Returns null if their dimensions are possible; their decompressed size is
// then at most 64 times the compressed size.
char const* find_flaw(CompressedElements const& elements);

// Decompresses elements into `to`, whose size must be count * stride. find_flaw() must be null for
// the elements. Returns false if their bytes are damaged. Safe for arbitrary bytes.
bool decompress(CompressedElements const& elements, std::span<std::byte> to);

} // namespace tractus::exports
