#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::leaf {

// A page of square cells with a leaf each, rows from the top; `channels` bytes to a pixel.
struct CellPage {
    int side = 0; // Pixels; a multiple of `cell`, which is a power of two.
    int cell = 0;
    int channels = 4;
    std::vector<std::uint8_t> pixels {};
};

// Content of a page, which says how four of its bytes become one.
enum class PageKind {
    Color,  // sRGB, mixed in linear light; a fourth channel is alpha.
    Normal, // Directions: they stay of length 1.
    Plain,
};

// Returns the page half as wide and high. Its cells must be 2 pixels wide or more.
CellPage half_page(CellPage const& page, PageKind kind);

// How much of each cell is there where what is less than half opaque is cut away, 0 to 1, in the
// order of the cells. The page has four channels.
std::vector<double> alpha_coverage(CellPage const& page);

// Scales the alpha of each cell so that as much of it is there as `wanted` says (Castaño,
// "Computing alpha mipmaps", 2010): means of alpha lose what is thin.
void keep_coverage(CellPage& page, std::span<double const> wanted);

} // namespace tractus::leaf
