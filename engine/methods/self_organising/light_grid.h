#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/cell_index.h"
#include "engine/methods/self_organising/laws.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::self_organising {

// Shade by shadow propagation (Palubicki et al. 2009): a point adds shade * fall^-k to the cells of
// the k-th layer below its own, in a square of 2 k + 1 cells' side, for k from 0 to the depth. Each
// cell adds up in the order of the points, so the sums are the same on any number of threads.
class LightGrid {
public:
    // Fails, as the user's fault, where the points spread over more cells than memory should hold.
    static Result<LightGrid> make(std::span<Vec3 const> points, Laws const& laws);

    // The shade in a cell; 0 beyond all points' reach.
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

    Cell low_ {};  // The first cell: within the depth's reach of the points on all sides but above.
    Cell size_ {}; // In cells.
    std::vector<double> shade_;
};

} // namespace tractus::self_organising
