#pragma once

#include "engine/export/png.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tractus::leaf {

// A map's pixels as bytes, with interleaved channels.
template<std::size_t N>
std::span<std::uint8_t const> bytes_of(std::vector<std::array<std::uint8_t, N>> const& pixels)
{
    static_assert(sizeof(pixels[0]) == N);
    return { pixels.empty() ? nullptr : pixels.front().data(), N * pixels.size() };
}

// Encodes a square map as a PNG file with fast compression.
template<std::size_t N>
std::string packed_map(std::vector<std::array<std::uint8_t, N>> const& pixels)
{
    auto const side = static_cast<int>(std::lround(std::sqrt(double(pixels.size()))));
    return exports::png_bytes({ .width = side,
                                .height = side,
                                .channels = static_cast<int>(N),
                                .pixels = bytes_of(pixels),
                                .packing = exports::PngPicture::Packing::Fast });
}

} // namespace tractus::leaf
