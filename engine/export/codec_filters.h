#pragma once

#include "engine/base/vectors.h"

#include <cstdint>
#include <span>

namespace tractus::exports {

// Encoders for the filters of EXT_meshopt_compression, which map numbers to fewer and more similar
// bytes.

// Filter OCTAHEDRAL with 8 bits: encodes unit vectors of our frame in four bytes each, in glTF's
// frame. For tangents w is 1 or -1. Directions are accurate to 1.3 degrees.
void encode_octahedral(std::span<Vec3f const> vectors, std::int8_t* to);
void encode_octahedral(std::span<Eigen::Vector4f const> tangents, std::int8_t* to);

// Filter EXPONENTIAL with one exponent for all values: rounds to 1/4096 if all are below 1024, and
// otherwise to 1/4,194,304 of the power of two above the largest.
void encode_exponential(std::span<float const> values, std::uint32_t* to);

} // namespace tractus::exports
