#pragma once

#include <cstdint>
#include <cstring>

// The calling convention for a Four depends on the target processor, which matters only between
// separately compiled libraries. The functions here and those that take a Four are all inlined or
// belong to one library.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace tractus {

// Four numbers that a processor handles as one SIMD vector, or as two halves: a vector extension of
// g++ and clang that works on every processor. + - * / act on each element, and the results equal
// those of scalar arithmetic bit for bit; a comparison yields a mask for ?:.
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

// Four quaternions or four vectors, stored by component.
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

// The inverse rotation, q^-1 v q, of each vector.
inline FourVectors turned_back(FourQuats const& q, FourVectors const& v)
{
    Four const ux = 2 * (q.z * v.y - q.y * v.z);
    Four const uy = 2 * (q.x * v.z - q.z * v.x);
    Four const uz = 2 * (q.y * v.x - q.x * v.y);
    return { v.x + q.w * ux - (q.y * uz - q.z * uy), v.y + q.w * uy - (q.z * ux - q.x * uz),
             v.z + q.w * uz - (q.x * uy - q.y * ux) };
}

} // namespace tractus
