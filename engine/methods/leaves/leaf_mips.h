#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::leaf {

// An atlas of square cells with one leaf in each. `pixels` has rows from the top and `channels`
// bytes per pixel.
struct CellPage {
    int side = 0; // Side of the page in pixels; a multiple of `cell`, which is a power of two.
    int cell = 0;
    int channels = 4;
    std::vector<std::uint8_t> pixels {};
};

// Type of a page's content, which determines how four pixels are averaged to one.
enum class PageKind {
    Color,  // Colours in sRGB, averaged in linear light; an optional fourth channel is alpha.
    Normal, // Normals as unit vectors, renormalised after averaging.
    Plain,
};

// Returns the page at half its resolution. The cells of `page` must be at least 2 pixels wide.
CellPage half_page(CellPage const& page, PageKind kind);

// Returns, for each cell in order, the share of its pixels whose alpha is at least one half, 0 to
// 1. The page must have four channels.
std::vector<double> alpha_coverage(CellPage const& page);

// Scales the alpha of each cell so that alpha_coverage() returns `wanted` (Castaño, "Computing
// alpha mipmaps", 2010). Without this, averaging makes thin parts of leaves vanish.
void keep_coverage(CellPage& page, std::span<double const> wanted);

} // namespace tractus::leaf
