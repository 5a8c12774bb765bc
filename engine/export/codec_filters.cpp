#include "engine/export/codec_filters.h"

#include "engine/export/turned_vectors.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace tractus::exports {
namespace {

constexpr float kOne = 127;
// Number of bits, without the sign, of the integers that round_to_integer_bits() can return.
constexpr int kMantissaBits = 22;
constexpr int kMinExponent = -12;

FourFloats magnitudes(FourFloats const& values)
{
    return values < 0 ? -values : values;
}

// Returns the absolute values `sizes` with the signs of `signs`.
FourFloats with_signs(FourFloats const& sizes, FourFloats const& signs)
{
    return signs < 0 ? -sizes : sizes;
}

// Projects vectors onto an octahedron whose lower half is folded over the upper one. Each result
// has one byte for each of the two coordinates, for the value 1 (as 127) and for `w`.
FourInts octahedral_bytes(TurnedVectors const& v, FourInts const& w)
{
    FourFloats const scale = kOne / (magnitudes(v.x) + magnitudes(v.y) + magnitudes(v.z));
    FourFloats const x = v.x * scale;
    FourFloats const y = v.y * scale;
    FourFloats const folded_x = v.z < 0 ? with_signs(kOne - magnitudes(y), x) : x;
    FourFloats const folded_y = v.z < 0 ? with_signs(kOne - magnitudes(x), y) : y;
    return (round_to_integer_bits(bounded(folded_x, kOne)) & 0xFF)
        | (round_to_integer_bits(bounded(folded_y, kOne)) & 0xFF) << 8
        | static_cast<int>(kOne) << 16 | (w & 0xFF) << 24;
}

TurnedVectors turned_tangents(Eigen::Vector4f const* four, FourFloats& w)
{
    auto const a = load_four(four[0].data());
    auto const b = load_four(four[1].data());
    auto const c = load_four(four[2].data());
    auto const d = load_four(four[3].data());
    auto const xy01 = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    auto const xy23 = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    auto const zw01 = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    auto const zw23 = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    w = __builtin_shufflevector(zw01, zw23, 2, 3, 6, 7);
    return { __builtin_shufflevector(xy01, xy23, 0, 1, 4, 5),
             __builtin_shufflevector(zw01, zw23, 0, 1, 4, 5),
             -__builtin_shufflevector(xy01, xy23, 2, 3, 6, 7) };
}

float largest_of(std::span<float const> values)
{
    FourFloats largest {};
    std::size_t i = 0;
    for (; i + 4 <= values.size(); i += 4) {
        auto const sizes = magnitudes(load_four(&values[i]));
        largest = sizes > largest ? sizes : largest;
    }
    float most = std::max({ largest[0], largest[1], largest[2], largest[3] });
    for (; i < values.size(); ++i)
        most = std::max(most, std::abs(values[i]));
    return std::min(most, std::numeric_limits<float>::max());
}

} // namespace

void encode_octahedral(std::span<Vec3f const> vectors, std::int8_t* to)
{
    for_each_four(vectors, [&](Vec3f const* from, std::size_t first, std::size_t count) {
        auto const four = octahedral_bytes(turned_vectors(from), FourInts {});
        std::memcpy(to + 4 * first, &four, 4 * count);
    });
}

void encode_octahedral(std::span<Eigen::Vector4f const> tangents, std::int8_t* to)
{
    for_each_four(tangents, [&](Eigen::Vector4f const* from, std::size_t first, std::size_t count) {
        FourFloats w;
        auto const turned = turned_tangents(from, w);
        auto const four = octahedral_bytes(turned, round_to_integer_bits(bounded(w * kOne, kOne)));
        std::memcpy(to + 4 * first, &four, 4 * count);
    });
}

void encode_exponential(std::span<float const> values, std::uint32_t* to)
{
    float const largest = largest_of(values);
    int const exponent = largest > 0
        ? std::max(kMinExponent, std::ilogb(largest) + 1 - kMantissaBits)
        : kMinExponent;
    float const scale = std::ldexp(1.0f, -exponent);
    auto const most = static_cast<float>((1 << kMantissaBits) - 1);
    auto const exponent_bits
        = static_cast<std::int32_t>(static_cast<std::uint32_t>(exponent) << 24);
    auto const encode = [&](FourFloats const& four) -> FourInts {
        auto const mantissas = round_to_integer_bits(bounded(four * scale, most))
            - round_to_integer_bits(FourFloats {});
        return (mantissas & 0xFFFFFF) | exponent_bits;
    };
    std::size_t i = 0;
    for (; i + 4 <= values.size(); i += 4) {
        auto const four = encode(load_four(&values[i]));
        std::memcpy(to + i, &four, sizeof four);
    }
    if (i == values.size())
        return;
    FourFloats last {};
    std::copy(values.begin() + static_cast<std::ptrdiff_t>(i), values.end(),
              reinterpret_cast<float*>(&last));
    auto const four = encode(last);
    std::memcpy(to + i, &four, sizeof(float) * (values.size() - i));
}

} // namespace tractus::exports
