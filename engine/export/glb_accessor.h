#pragma once

#include "engine/base/bulk_vector.h"
#include "engine/base/result.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tinygltf {
class Model;
}

namespace tractus::exports {

// Reads the elements of an accessor with `Components` numbers each; normalised integers are
// converted to -1…1 or 0…1. Fails if there is no such accessor, if it has a different number of
// components or exceeds its buffer, or if it is of a kind that is not supported. Safe for arbitrary
// bytes.
template<std::size_t Components>
Result<std::vector<std::array<float, Components>>> read_accessor(tinygltf::Model const& model,
                                                                 int accessor);

extern template Result<std::vector<std::array<float, 2>>> read_accessor<2>(tinygltf::Model const&,
                                                                           int);
extern template Result<std::vector<std::array<float, 3>>> read_accessor<3>(tinygltf::Model const&,
                                                                           int);
extern template Result<std::vector<std::array<float, 4>>> read_accessor<4>(tinygltf::Model const&,
                                                                           int);

// Reads vertex indices. Fails where read_accessor() fails, and if an index is not below
// `vertex_count`.
Result<BulkVector<std::uint32_t>> read_indices(tinygltf::Model const& model, int accessor,
                                               std::size_t vertex_count);

} // namespace tractus::exports
