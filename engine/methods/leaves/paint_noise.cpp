#include "engine/methods/leaves/paint_noise.h"

#include <algorithm>
#include <cmath>

namespace tractus::leaf {

namespace {

// Number of cells along a side of a table: cells of the first octave, or large meshes.
constexpr int kCells = 16;

double eased(double x)
{
    x = std::clamp(x, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

// Random value at a point of a grid that repeats after `cells` cells in each direction.
double lattice(std::uint64_t seed, std::int64_t x, std::int64_t y, std::int64_t cells)
{
    return grid_hash(seed, (x + cells) % cells, (y + cells) % cells);
}

double value_noise(std::uint64_t seed, Vec2 const& at, std::int64_t cells)
{
    auto const i = static_cast<std::int64_t>(at.x());
    auto const j = static_cast<std::int64_t>(at.y());
    double const u = eased(at.x() - double(i));
    double const v = eased(at.y() - double(j));
    double const low = std::lerp(lattice(seed, i, j, cells), lattice(seed, i + 1, j, cells), u);
    double const high
        = std::lerp(lattice(seed, i, j + 1, cells), lattice(seed, i + 1, j + 1, cells), u);
    return std::lerp(low, high, v);
}

// Weighted mean of three octaves of value noise. `at` is from 0 to 1 across the table.
double cloud(Vec2 const& at)
{
    constexpr std::int64_t kSecond = 34;
    constexpr std::int64_t kThird = 69;
    return (4 * value_noise(1, kCells * at, kCells) + 2 * value_noise(2, kSecond * at, kSecond)
            + value_noise(3, kThird * at, kThird))
        / 7;
}

// Distance from the nearest border between Voronoi cells: 0 on the border, about 0.5 in the middle
// of a cell. The cells belong to random points, one in each square of the grid.
double border(std::uint64_t seed, Vec2 const& at, std::int64_t cells)
{
    double first = 1e9;
    double second = 1e9;
    auto const x = static_cast<std::int64_t>(at.x());
    auto const y = static_cast<std::int64_t>(at.y());
    for (auto j = y - 1; j <= y + 1; ++j)
        for (auto i = x - 1; i <= x + 1; ++i) {
            Vec2 const point(double(i) + lattice(seed, i, j, cells),
                             double(j) + lattice(seed + 7, i, j, cells));
            double const distance = (point - at).squaredNorm();
            second = std::min(second, std::max(first, distance));
            first = std::min(first, distance);
        }
    return std::sqrt(second) - std::sqrt(first);
}

double mesh(Vec2 const& at)
{
    constexpr std::int64_t kFine = 43;
    double const coarse = border(41, kCells * at, kCells);
    double const fine = border(43, kFine * at, kFine);
    return std::max(1 - eased(coarse / 0.16), 0.5 * (1 - eased(fine / 0.22)));
}

} // namespace

double grid_hash(std::uint64_t seed, std::int64_t x, std::int64_t y)
{
    auto word = seed * 0x9E3779B97F4A7C15u + static_cast<std::uint64_t>(x) * 0xBF58476D1CE4E5B9u
        + static_cast<std::uint64_t>(y) * 0x94D049BB133111EBu;
    word = (word ^ (word >> 30)) * 0xBF58476D1CE4E5B9u;
    word = (word ^ (word >> 27)) * 0x94D049BB133111EBu;
    return static_cast<double>((word ^ (word >> 31)) >> 11) * 0x1p-53;
}

template<typename At>
NoiseTable::NoiseTable(int cells, At const& at)
    : per_cell_(static_cast<float>(kSide) / static_cast<float>(cells))
{
    values_.reserve(kSide * kSide);
    for (std::uint32_t y = 0; y < kSide; ++y)
        for (std::uint32_t x = 0; x < kSide; ++x)
            values_.push_back(static_cast<float>(at(Vec2(x, y) / double(kSide))));
}

NoiseTable const& NoiseTable::clouds()
{
    static NoiseTable const table(kCells, cloud);
    return table;
}

NoiseTable const& NoiseTable::net()
{
    static NoiseTable const table(kCells, mesh);
    return table;
}

Noise::Noise(NoiseTable const& table, std::uint64_t seed, double cells)
    : table_(&table)
    , x0_(static_cast<float>(kCells * grid_hash(seed, 1, 0)))
    , y0_(static_cast<float>(kCells * grid_hash(seed, 0, 1)))
    , scale_(static_cast<float>(cells))
{
}

} // namespace tractus::leaf
