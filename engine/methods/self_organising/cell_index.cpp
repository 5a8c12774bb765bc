#include "engine/methods/self_organising/cell_index.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tractus::self_organising {

Cell cell_at(Vec3 const& position, double side)
{
    // Maximum absolute value of a cell coordinate; a double cannot represent much larger integers
    // exactly.
    constexpr double kFarthest = 1e15;
    auto const along = [&](double x) {
        return static_cast<std::int64_t>(std::clamp(std::floor(x / side), -kFarthest, kFarthest));
    };
    return { along(position.x()), along(position.y()), along(position.z()) };
}

CellIndex::CellIndex(std::span<Vec3 const> points, double side)
    : side_(side)
    , mask_(std::bit_ceil(std::max<std::size_t>(points.size(), 8)) - 1)
    , starts_(mask_ + 2)
    , numbers_(points.size())
{
    std::vector<std::uint32_t> slots(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        slots[i] = static_cast<std::uint32_t>(slot_of(cell_at(points[i], side)));
        ++starts_[slots[i] + 1];
    }
    for (std::size_t i = 1; i < starts_.size(); ++i)
        starts_[i] += starts_[i - 1];
    auto next = starts_;
    for (std::size_t i = 0; i < points.size(); ++i)
        numbers_[next[slots[i]]++] = static_cast<std::uint32_t>(i);
}

std::size_t CellIndex::slot_of(Cell const& cell) const
{
    // Hash function of Teschner et al., "Optimized spatial hashing for collision detection", 2003,
    // extended to 64 bits.
    auto const mixed = static_cast<std::uint64_t>(cell[0]) * 0x9E3779B97F4A7C15U
        ^ static_cast<std::uint64_t>(cell[1]) * 0xC2B2AE3D27D4EB4FU
        ^ static_cast<std::uint64_t>(cell[2]) * 0x165667B19E3779F9U;
    return static_cast<std::size_t>(mixed ^ mixed >> 29) & mask_;
}

} // namespace tractus::self_organising
