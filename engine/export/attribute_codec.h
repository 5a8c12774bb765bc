#pragma once

#include "engine/base/bulk_vector.h"

#include <cstddef>
#include <span>

namespace tractus::exports {

// Compresses elements of `element_bytes` (a multiple of four, 256 at most) by mode ATTRIBUTES of
// glTF's extension EXT_meshopt_compression, of which meshoptimizer's own encoder makes as many
// bytes in three times the time. Replaces what `to` holds.
void compress_attributes(std::span<std::byte const> elements, std::size_t element_bytes,
                         BulkVector<std::byte>& to);

} // namespace tractus::exports
