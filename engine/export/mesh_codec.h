#pragma once

#include "engine/base/bulk_vector.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace tractus::exports {

// The codecs of glTF's extension EXT_meshopt_compression that meshoptimizer has, but for the
// encoder of attribute_codec.h. Functions may be called on any threads.

enum class CodecMode { Attributes, Triangles, Indices };
enum class CodecFilter { None, Octahedral, Quaternion, Exponential };

// Compresses indices by mode INDICES, and replaces what `to` holds. TRIANGLES takes six times as
// long for the order in which tubes have their triangles, and is no smaller.
void compress_indices(std::span<std::uint32_t const> indices, BulkVector<std::byte>& to);

// What a file says of compressed elements.
struct CompressedElements {
    CodecMode mode = CodecMode::Attributes;
    CodecFilter filter = CodecFilter::None;
    std::uint64_t count = 0;
    std::uint64_t stride = 0; // Bytes of an element.
    std::span<std::byte const> bytes {};
};

// Says why these cannot be decompressed, whatever the bytes are, as the end of a sentence; null if
// they perhaps can. Then they take at most 64 times as many bytes as they are compressed.
char const* flaw_in(CompressedElements const& elements);

// Decompresses elements without such a flaw into `to`, which has count * stride bytes. Any bytes
// are safe to give. False if they are damaged.
bool decompress(CompressedElements const& elements, std::span<std::byte> to);

} // namespace tractus::exports
