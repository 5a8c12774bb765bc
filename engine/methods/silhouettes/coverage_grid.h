#pragma once

#include "engine/methods/silhouettes/plane.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::silhouette {

// Raster of the covered part of an outline: 256 cells along the longer side of its bounding box.
class CoverageGrid {
public:
    static constexpr int kCells = 256;

    explicit CoverageGrid(std::span<Vec2 const> outline);

    // The cells whose centres are inside a polygon (even-odd rule).
    struct Cells {
        int first_row = 0;
        std::vector<std::uint64_t> bits; // One bit per cell, four words per row of cells.
        std::size_t count = 0;
    };
    Cells cells_of(std::span<Vec2 const> polygon) const;

    // Number of the given cells that are already covered.
    std::size_t count_covered(Cells const& cells) const;
    void cover(Cells const& cells);

    // Share of the outline's cells that are covered.
    double coverage() const;

    // is_inside(): the point's cell belongs to the outline. is_free(): it does and is not covered.
    bool is_inside(Vec2 const& point) const;
    bool is_free(Vec2 const& point) const;

    double cell() const { return cell_; }

    // The free point farthest from all covered cells and from the outside, examining every
    // `step`-th cell of every `step`-th row (`step` 1 to 8). Radius 0 if nothing is free.
    struct Gap {
        Vec2 center = Vec2::Zero();
        double radius = 0;
    };
    Gap widest_gap(int step) const;

private:
    int row_of(Vec2 const& point) const;
    int column_of(Vec2 const& point) const;

    Vec2 low_;
    double cell_ = 1;
    int rows_ = 0;
    std::vector<std::uint64_t> whole_;
    std::vector<std::uint64_t> covered_;
    std::size_t whole_count_ = 0;
};

} // namespace tractus::silhouette
