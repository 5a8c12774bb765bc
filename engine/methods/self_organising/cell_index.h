#pragma once

#include "engine/base/vectors.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::self_organising {

// Integer place of a cell of a grid through the origin.
using Cell = std::array<std::int64_t, 3>;

Cell cell_at(Vec3 const& position, double side);

// Points by the cells of a grid that they lie in: a hash table whose slots list their points. Cells
// of other places may share a slot, so whoever asks looks at the points' positions as well.
class CellIndex {
public:
    // `side`: of a cell, above 0.
    CellIndex(std::span<Vec3 const> points, double side);

    // Calls use(number) for the points in the 27 cells around a position, and perhaps for others,
    // some of them twice.
    template<typename Use> void for_each_near(Vec3 const& position, Use use) const
    {
        auto const [x, y, z] = cell_at(position, side_);
        for (std::int64_t k = z - 1; k <= z + 1; ++k)
            for (std::int64_t j = y - 1; j <= y + 1; ++j)
                for (std::int64_t i = x - 1; i <= x + 1; ++i) {
                    auto const slot = slot_of({ i, j, k });
                    for (auto at = starts_[slot]; at < starts_[slot + 1]; ++at)
                        use(numbers_[at]);
                }
    }

private:
    std::size_t slot_of(Cell const& cell) const;

    double side_;
    std::size_t mask_;                   // Number of slots, a power of two, less 1.
    std::vector<std::uint32_t> starts_;  // Of each slot, into numbers_; and the end.
    std::vector<std::uint32_t> numbers_; // Of points, in their order within a slot.
};

} // namespace tractus::self_organising
