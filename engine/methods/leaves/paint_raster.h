#pragma once

#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_triangles.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::leaf {

// Division of a square picture into square tiles, in rows from the top. The last row and column of
// tiles may be cut off by the picture's edge.
class TileGrid {
public:
    static constexpr int kTile = 16; // Side of a tile in pixels.

    // Marks the tiles that contain pixels of the leaf, or pixels that are read by filters and in
    // computing normals at the leaf's edge.
    void find(std::span<float const> coverage, int side);

    int side() const { return side_; }
    int columns() const { return columns_; } // Number of columns of tiles; there are as many rows.
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

// Computes the share of each pixel that a leaf covers. Each edge of a triangle adds signed areas,
// which are finally summed along the rows of pixels.
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
    // Adds an edge's part within one pixel; `middle` is the part's mean position in the pixel, 0 at
    // its left side and 1 at its right.
    void add_part(int x, int y, double height, double middle);

    int side_ = 0;
    std::vector<float> sums_; // Signed areas, to be summed along each row; side + 2 values per row.
};

// Output maps of map_veins(), one value per pixel. In tiles that TileGrid::find() has not marked,
// only `protection` is set.
struct VeinMaps {
    // Distance to the nearest vein's margin, in pixels; 0 inside a vein.
    std::vector<float>& distance;
    std::vector<float>& profile; // Vein profile V: 1 in the middle of a vein, 0 beside it.
    // Protection P: 1 in spared veins, decreasing beside them, 0 far away.
    std::vector<float>& protection;
    // Order of the vein to which the profile belongs; 9 if there is none.
    std::vector<std::uint8_t>& order;
};

struct VeinMapOptions {
    float reach = 0;      // Upper limit of VeinMaps::distance, in pixels.
    int spared_order = 2; // Veins up to this order are spared by larvae.
};

// Computes exact vein maps. `veins` are in pixels. For each tile, only those veins are considered
// that can be nearest to one of its pixels.
void map_veins(std::span<Leaf::Vein const> veins, TileGrid const& tiles,
               VeinMapOptions const& options, VeinMaps const& maps);

} // namespace tractus::leaf
