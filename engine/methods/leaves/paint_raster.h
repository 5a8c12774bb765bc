#pragma once

#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_triangles.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::leaf {

// Division of a square picture into square tiles, rows from the top. The last tiles can be partial.
class TileGrid {
public:
    static constexpr int kTile = 16; // Side of a tile in pixels.

    // Marks the tiles that contain pixels of the leaf, or pixels that filters and normals at the
    // leaf's edge read.
    void find(std::span<float const> coverage, int side);

    int side() const { return side_; }
    int columns() const { return columns_; } // Number of columns, which is also the number of rows.
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
    // True for each block of 4 by 4 pixels that contains a pixel of the leaf.
    std::vector<std::uint8_t> blocks_;
};

// Accumulates the area of each pixel that a leaf covers, from signed areas of edges summed along
// rows.
class CoverageRaster {
public:
    void begin(int side);
    // Adds a triangle in pixel coordinates, with either orientation.
    void add_triangle(Vec2 const& a, Vec2 const& b, Vec2 const& c);
    // Writes the coverage of each pixel, 0 to 1.
    void finish(std::vector<float>& coverage) const;

private:
    void add_line(Vec2 const& a, Vec2 const& b);
    void add_in_row(int y, double height, double x0, double x1);
    // Adds a part of a pixel; `middle` is its mean position within the pixel, 0 at the left side to
    // 1 at the right.
    void add_part(int x, int y, double height, double middle);

    int side_ = 0;
    std::vector<float> sums_; // Running sums, side + 2 values per row.
};

// Output maps of map_veins(). Pixels in unmarked tiles only get protection.
struct VeinMaps {
    std::vector<float>& distance; // Distance to the nearest vein's side, in pixels; 0 inside.
    std::vector<float>& profile;  // Profile V: 1 in the middle of a vein, 0 beside it.
    // Protection P: 1 where a vein is spared, fading beside it; 0 far away.
    std::vector<float>& protection;
    std::vector<std::uint8_t>& order; // Order of the vein to which the profile belongs; 9: none.
};

struct VeinMapOptions {
    float reach = 0;      // Upper limit of distances, in pixels.
    int spared_order = 2; // Highest order of the veins that are spared.
};

// Computes exact vein maps. `veins` are in pixels. For each tile only the veins are considered that
// can be nearest to one of its pixels.
void map_veins(std::span<Leaf::Vein const> veins, TileGrid const& tiles,
               VeinMapOptions const& options, VeinMaps const& maps);

} // namespace tractus::leaf
