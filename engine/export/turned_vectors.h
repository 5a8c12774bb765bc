#pragma once

#include "engine/base/four.h"
#include "engine/base/vectors.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>

namespace tractus::exports {

// Helpers for converting vectors to glTF's frame and to integers, four at a time.

// Four vectors in glTF's frame: their x, their y and their z coordinates.
struct TurnedVectors {
    FourFloats x, y, z;
};

inline TurnedVectors turned_vectors(Vec3f const* four)
{
    auto const a = load_four(four->data());     // Coordinates x0 y0 z0 x1.
    auto const b = load_four(four->data() + 4); // Coordinates y1 z1 x2 y2.
    auto const c = load_four(four->data() + 8); // Coordinates z2 x3 y3 z3.
    auto const x23 = __builtin_shufflevector(b, c, 2, 2, 5, 5);
    auto const y01 = __builtin_shufflevector(a, b, 1, 1, 4, 4);
    auto const y23 = __builtin_shufflevector(b, c, 3, 3, 6, 6);
    auto const z01 = __builtin_shufflevector(a, b, 2, 2, 5, 5);
    return { __builtin_shufflevector(a, x23, 0, 3, 4, 6),
             __builtin_shufflevector(z01, c, 0, 2, 4, 7),
             -__builtin_shufflevector(y01, y23, 0, 2, 4, 6) };
}

// Calls use(four vectors, first, count) for all vectors, four at a time. `first` is the index of
// the first of the four. If only `count` < 4 vectors are left, the last one is repeated.
template<typename Vector, typename Use>
void for_each_four(std::span<Vector const> vectors, Use const& use)
{
    std::size_t i = 0;
    for (; i + 4 <= vectors.size(); i += 4)
        use(&vectors[i], i, std::size_t { 4 });
    if (i == vectors.size())
        return;
    std::array<Vector, 4> last;
    for (std::size_t k = 0; k < last.size(); ++k)
        last[k] = vectors[std::min(i + k, vectors.size() - 1)];
    use(last.data(), i, vectors.size() - i);
}

// Clamps values to the range from -most to most; NaN also becomes a value in this range.
inline FourFloats bounded(FourFloats const& values, float most)
{
    auto const below = values < most ? values : FourFloats {} + most;
    return below > -most ? below : FourFloats {} - most;
}

// Rounds values of less than 2^15 in absolute value to the nearest integer, ties to even. The
// integers are in the low bits of the result. Works by adding a number so large that no bits for
// fractions remain.
inline FourInts round_to_integer_bits(FourFloats const& values)
{
    return std::bit_cast<FourInts>(values + 0x1.8p23f);
}

} // namespace tractus::exports
