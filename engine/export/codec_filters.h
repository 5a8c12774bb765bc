#pragma once

#include "engine/base/vectors.h"

#include <cstdint>
#include <span>

namespace tractus::exports {

// What the filters of EXT_meshopt_compression undo: numbers of few and similar bytes.

// Filter OCTAHEDRAL with 8 bits, of unit vectors in our frame: four bytes each, glTF's frame. Of
// tangents w is 1 or -1. Directions come back within 1.3 degrees.
void encode_octahedral(std::span<Vec3f const> vectors, std::int8_t* to);
void encode_octahedral(std::span<Eigen::Vector4f const> tangents, std::int8_t* to);

// Filter EXPONENTIAL, one exponent for all: to 1/4096, rounded, unless one of them is 1024 or more;
// then to 1/4,194,304 of the power of two above the largest.
void encode_exponential(std::span<float const> values, std::uint32_t* to);

} // namespace tractus::exports
