#pragma once

#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_triangles.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::leaf {

// A square picture's pixels in square tiles, rows from the top. The last tiles may be cut off.
class TileGrid {
public:
    static constexpr int kTile = 16; // Pixels.

    // Marks the tiles that have a pixel of the leaf, or one of which a filter or a normal that
    // looks at the leaf's edge may ask.
    void find(std::span<float const> coverage, int side);

    int side() const { return side_; }
    int columns() const { return columns_; } // Rows as well.
    bool is_near(int column, int row) const { return is_near_[index(column, row)] != 0; }

private:
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_)
            + static_cast<std::size_t>(column);
    }

    int side_ = 0;
    int columns_ = 0;
    std::vector<std::uint8_t> is_near_;
    std::vector<std::uint8_t> blocks_; // Blocks of 4 pixels: whether they have one of the leaf.
};

// How much of each pixel a leaf covers: lines' signed areas, summed along rows.
class CoverageRaster {
public:
    void begin(int side);
    // Adds a triangle, in pixels; either way round.
    void add_triangle(Vec2 const& a, Vec2 const& b, Vec2 const& c);
    // 0 to 1 for each pixel.
    void finish(std::vector<float>& coverage) const;

private:
    void add_line(Vec2 const& a, Vec2 const& b);
    void add_in_row(int y, double height, double x0, double x1);
    // `middle`: 0 at the pixel's left side, 1 at its right.
    void add_part(int x, int y, double height, double middle);

    int side_ = 0;
    std::vector<float> sums_; // side + 2 in a row.
};

// Where to put what pixels know of the veins round them. Pixels of tiles that are not near get no
// values but protection.
struct VeinMaps {
    std::vector<float>& distance;     // To the nearest vein's side, in pixels, 0 inside.
    std::vector<float>& profile;      // V: 1 on a vein's middle, 0 beside it.
    std::vector<float>& protection;   // P: 1 where a vein is spared, fading beside it; 0 far away.
    std::vector<std::uint8_t>& order; // Order of the vein of which V is; 9 where none is.
};

struct VeinMapOptions {
    float reach = 0;      // No distance is more.
    int spared_order = 2; // Veins up to this order are spared.
};

// `veins` in pixels. Every distance is exact: for each tile those veins are looked at that may be
// the nearest to one of its pixels.
void map_veins(std::span<Leaf::Vein const> veins, TileGrid const& tiles,
               VeinMapOptions const& options, VeinMaps const& maps);

} // namespace tractus::leaf
