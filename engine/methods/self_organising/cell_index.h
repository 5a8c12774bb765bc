#pragma once

#include "engine/base/vectors.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::self_organising {

// Integer coordinates of a cell in a grid of cubes; cell (0, 0, 0) begins at the origin.
using Cell = std::array<std::int64_t, 3>;

Cell cell_at(Vec3 const& position, double side);

// A spatial hash table: finds points by the grid cell that contains them. Different cells may share
// a slot, so callers must check the distance to each point.
class CellIndex {
public:
    // `side` is the length of a cell's edge, above 0.
    CellIndex(std::span<Vec3 const> points, double side);

    // Calls use(index) for each point in the 27 cells around a position, and possibly for other
    // points or for the same point twice.
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
    std::size_t mask_; // Number of slots, a power of two, minus 1.
    // Index in numbers_ at which each slot starts; the last entry is the number of points.
    std::vector<std::uint32_t> starts_;
    // Indices of the points, grouped by slot, ascending within each slot.
    std::vector<std::uint32_t> numbers_;
};

} // namespace tractus::self_organising
