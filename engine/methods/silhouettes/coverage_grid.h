#pragma once

#include "engine/methods/silhouettes/plane.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::silhouette {

// What part of an outline's inside is covered: 256 cells along the longer side of its box.
class CoverageGrid {
public:
    static constexpr int kCells = 256;

    explicit CoverageGrid(std::span<Vec2 const> outline);

    // Cells of a polygon, those whose middles are inside by even and odd.
    struct Cells {
        int first_row = 0;
        std::vector<std::uint64_t> bits; // Four words a row.
        std::size_t count = 0;
    };
    Cells cells_of(std::span<Vec2 const> polygon) const;

    // How many of the cells are covered already.
    std::size_t count_covered(Cells const& cells) const;
    void cover(Cells const& cells);

    // The share of the outline's cells that is covered.
    double coverage() const;

    // Whether the cell of a point is one of the outline's; and not covered.
    bool is_inside(Vec2 const& point) const;
    bool is_free(Vec2 const& point) const;

    double cell() const { return cell_; }

    // The free place that is farthest from all that is covered or outside, by looking at every
    // `step`-th cell of every `step`-th row; radius 0 where nothing is free. 1 to 8.
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
