#pragma once

#include "engine/stroke/frame_rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace tractus::variation {

// Deviations of a growing tip from its predefined direction: angles in radians, towards a segment's
// normal (x) and binormal (y). The functions are templates on the number type, so that several axes
// can be computed at once.

// Upper limit on the deviation, in radians: the tip then points almost backwards.
constexpr double kMaxDeviation = 3;

// cos(a / 2) and sin(a / 2) / a of an angle a. Number is a double or a Four.
template<typename Number> struct HalfAngle {
    Number cosine;
    Number sine_share;
};

// Returns the HalfAngle of an angle from 0 to kMaxDeviation, given its square. Both values are
// polynomials in (a / 2)²: Taylor series economised by Chebyshev polynomials on 0 to 2.25. They
// need no square root, division or branch, and are exact for 0. Errors are below 2e-18 (cosine) and
// 6e-17 (sine_share).
template<typename Number>
[[gnu::always_inline]] inline HalfAngle<Number> half_angle(Number const& angle_squared)
{
    constexpr std::array<double, 9> kCosine {
        1,
        -0.4999999999999999,
        0.04166666666666521,
        -0.0013888888888822129,
        2.480158728631636e-05,
        -2.7557317261220025e-07,
        2.0876608721823694e-09,
        -1.1464211340441154e-11,
        4.623779654783923e-14,
    };
    constexpr std::array<double, 8> kSine {
        1,
        -0.16666666666666355,
        0.008333333333304207,
        -0.00019841269830905871,
        2.7557317412497472e-06,
        -2.5051936357956436e-08,
        1.6049984230373593e-10,
        -7.398072770417901e-13,
    };
    Number const y = 0.25 * angle_squared;
    Number cosine = kCosine.back() * y + kCosine[kCosine.size() - 2];
    for (std::size_t n = kCosine.size() - 2; n-- > 0;)
        cosine = cosine * y + kCosine[n];
    Number sine = kSine.back() * y + kSine[kSine.size() - 2];
    for (std::size_t n = kSine.size() - 2; n-- > 0;)
        sine = sine * y + kSine[n];
    return { cosine, 0.5 * sine };
}

inline Vec2 held(Vec2 const& deviation)
{
    double const squared = deviation.squaredNorm();
    if (squared <= kMaxDeviation * kMaxDeviation) [[likely]]
        return deviation;
    return deviation * (kMaxDeviation / std::sqrt(squared));
}

// The part of an influence that acts across a tip with the deviation (dx, dy), as components along
// the segment's normal and binormal. (along, wx, wy) is the influence in the segment's frame.
template<typename Number> struct Push {
    Number x;
    Number y;
};
template<typename Number>
Push<Number> across(Number const& dx, Number const& dy, Number const& along, Number const& wx,
                    Number const& wy)
{
    Number const squared = dx * dx + dy * dy;
    auto const half = half_angle(squared);
    Number const sine_share = 2 * half.sine_share * half.cosine;
    Number const cosine = 1 - 2 * half.sine_share * half.sine_share * squared;
    Number const share = (along * cosine + sine_share * (wx * dx + wy * dy)) * sine_share;
    return { wx - share * dx, wy - share * dy };
}

inline Vec2 across(Vec2 const& d, Vec3 const& influence)
{
    auto const push = across(d.x(), d.y(), influence.x(), influence.y(), influence.z());
    return { push.x, push.y };
}

// Returns the twist-free rotation by the deviation `d`, in the segment's frame. `half` is the
// HalfAngle of |d|.
inline Quat turn_by(Vec2 const& d, HalfAngle<double> const& half)
{
    return Quat(half.cosine, 0, -half.sine_share * d.y(), half.sine_share * d.x());
}

} // namespace tractus::variation
