#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <vector>

namespace tractus::exports {

// A square, tileable height field, from which normal and occlusion maps are made. u increases from
// column to column, v from row to row.
class ReliefTile {
public:
    // `heights`: 0 to 1, row by row; side * side values.
    ReliefTile(int side, std::vector<double> heights);

    int side() const { return side_; }

    // Returns the height at a pixel. Beyond its edges the height field is repeated.
    double at(int column, int row) const { return heights_[index(column, row)]; }

    // Returns the pixel of the normal map (glTF 2.0 section 3.9.3: green points towards -v), 0 to
    // 1. `depth`: height of the relief, as a share of the tile's side.
    Vec3 normal(int column, int row, double depth) const;

    // Returns the share of the sky that is visible at a pixel, 0 to 1: less in furrows.
    double openness(int column, int row) const;

private:
    std::size_t index(int column, int row) const
    {
        auto const wrapped
            = [this](int i) { return static_cast<std::size_t>((i + side_) % side_); };
        return wrapped(row) * static_cast<std::size_t>(side_) + wrapped(column);
    }

    void find_means();

    int side_;
    std::vector<double> heights_;
    std::vector<double> means_; // Mean of the heights in a square around each pixel.
};

} // namespace tractus::exports
