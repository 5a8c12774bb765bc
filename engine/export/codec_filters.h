#pragma once

#include "engine/base/vectors.h"

#include <cstdint>
#include <span>

namespace tractus::exports {

// Encoders for the filters of EXT_meshopt_compression. A filter maps numbers to fewer and more
// similar bytes.

// Filter OCTAHEDRAL with 8 bits: encodes unit vectors, given in our frame, in glTF's frame with
// four bytes each. The w of a tangent is 1 or -1. Directions are accurate to 1.3 degrees.
void encode_octahedral(std::span<Vec3f const> vectors, std::int8_t* to);
void encode_octahedral(std::span<Eigen::Vector4f const> tangents, std::int8_t* to);

// Filter EXPONENTIAL with one exponent for all values. If all absolute values are below 1024,
// rounds to multiples of 1/4096; otherwise to 1/4,194,304 of the power of two above the largest
// one.
void encode_exponential(std::span<float const> values, std::uint32_t* to);

} // namespace tractus::exports
