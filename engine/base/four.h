#pragma once

#include <cstdint>
#include <cstring>

// How a Four is passed depends on the processor that is compiled for, which matters between
// libraries only. The functions of this file and those that take a Four are all inlined or of one.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace tractus {

// Four numbers on which a processor does the same at once, or in two halves: types that g++ and
// clang have on every processor. + - * / act on each of the four, and the results are those of
// plain numbers, bit for bit; a comparison gives a mask for ?:.
using Four = double __attribute__((vector_size(4 * sizeof(double))));
using FourFloats = float __attribute__((vector_size(4 * sizeof(float))));
using FourInts = std::int32_t __attribute__((vector_size(4 * sizeof(std::int32_t))));

inline Four load_four(double const* from)
{
    Four four;
    std::memcpy(&four, from, sizeof four);
    return four;
}

inline FourFloats load_four(float const* from)
{
    FourFloats four;
    std::memcpy(&four, from, sizeof four);
    return four;
}

inline void store(Four const& four, double* to)
{
    std::memcpy(to, &four, sizeof four);
}

// Quaternions and vectors of four.
struct FourQuats {
    Four w, x, y, z;
};

struct FourVectors {
    Four x, y, z;
};

inline FourQuats product(FourQuats const& a, FourQuats const& b)
{
    return { a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
             a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
             a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
             a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x };
}

// q^-1 v q.
inline FourVectors turned_back(FourQuats const& q, FourVectors const& v)
{
    Four const ux = 2 * (q.z * v.y - q.y * v.z);
    Four const uy = 2 * (q.x * v.z - q.z * v.x);
    Four const uz = 2 * (q.y * v.x - q.x * v.y);
    return { v.x + q.w * ux - (q.y * uz - q.z * uy), v.y + q.w * uy - (q.z * ux - q.x * uz),
             v.z + q.w * uz - (q.x * uy - q.y * ux) };
}

} // namespace tractus
