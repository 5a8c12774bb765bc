#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/cell_index.h"
#include "engine/methods/self_organising/laws.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::self_organising {

// Shade by shadow propagation (Palubicki et al. 2009), with the values of Laws: a point adds shade
// * shade_fall^-k to the cells of the k-th layer below its own layer, in a square with a side of 2
// k + 1 cells, for k from 0 to shade_depth. Each cell adds up its shade in the order of the points,
// so the result is the same on any number of threads.
class LightGrid {
public:
    // Computes the shade of points. Fails with a user error if the points spread over more cells
    // than fit into memory.
    static Result<LightGrid> make(std::span<Vec3 const> points, Laws const& laws);

    // The shade in a cell; 0 outside the grid.
    double shade_at(Cell const& cell) const
    {
        std::int64_t const i = cell[0] - low_[0];
        std::int64_t const j = cell[1] - low_[1];
        std::int64_t const k = cell[2] - low_[2];
        if (i < 0 || j < 0 || k < 0 || i >= size_[0] || j >= size_[1] || k >= size_[2])
            return 0;
        return shade_[static_cast<std::size_t>((k * size_[1] + j) * size_[0] + i)];
    }

private:
    void add_up(std::vector<Cell> const& cells, Laws const& laws);

    // First cell of the grid. The grid extends beyond the points as far as their shade reaches; at
    // the top it ends with the highest point.
    Cell low_ {};
    Cell size_ {}; // Number of cells along x, y and z.
    std::vector<double> shade_;
};

} // namespace tractus::self_organising
