#include "engine/methods/silhouettes/coverage_grid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace tractus::silhouette {

namespace {

constexpr int kWords = CoverageGrid::kCells / 64;

std::size_t word_of(int row, int column)
{
    return static_cast<std::size_t>(row * kWords + column / 64);
}

bool bit_at(std::vector<std::uint64_t> const& bits, int row, int column)
{
    return (bits[word_of(row, column)] >> static_cast<unsigned>(column % 64) & 1U) != 0;
}

// Inverts all cells of a row from a column on. Called at two edges of a polygon, it leaves the
// cells between them set.
void flip_from(std::uint64_t* row, int column)
{
    if (column >= CoverageGrid::kCells)
        return;
    int const word = column / 64;
    row[word] ^= ~std::uint64_t { 0 } << static_cast<unsigned>(column % 64);
    for (int w = word + 1; w < kWords; ++w)
        row[w] ^= ~std::uint64_t { 0 };
}

} // namespace

CoverageGrid::CoverageGrid(std::span<Vec2 const> outline)
{
    auto const box = box_of(outline);
    low_ = box.low;
    cell_ = (box.high - box.low).maxCoeff() / kCells;
    rows_ = std::clamp(static_cast<int>(std::ceil((box.high - box.low).y() / cell_)), 1, kCells);
    auto const words = static_cast<std::size_t>(rows_ * kWords);
    whole_.assign(words, 0);
    covered_.assign(words, 0);
    auto const cells = cells_of(outline);
    whole_count_ = cells.count;
    std::copy(cells.bits.begin(), cells.bits.end(),
              whole_.begin() + static_cast<std::ptrdiff_t>(cells.first_row) * kWords);
}

CoverageGrid::Cells CoverageGrid::cells_of(std::span<Vec2 const> polygon) const
{
    auto const box = box_of(polygon);
    auto const row_at = [&](double y) {
        return static_cast<int>(
            std::clamp(std::ceil((y - low_.y()) / cell_ - 0.5), 0.0, static_cast<double>(rows_)));
    };
    Cells cells { .first_row = row_at(box.low.y()), .bits = {} };
    auto const rows = std::max(0, row_at(box.high.y()) - cells.first_row);
    cells.bits.assign(static_cast<std::size_t>(rows * kWords), 0);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        auto const& a = polygon[i];
        auto const& b = polygon[(i + 1) % polygon.size()];
        auto const& lower = a.y() <= b.y() ? a : b;
        auto const& upper = a.y() <= b.y() ? b : a;
        for (int row = row_at(lower.y()); row < row_at(upper.y()); ++row) {
            double const y = low_.y() + (row + 0.5) * cell_;
            double const x
                = lower.x() + (y - lower.y()) / (upper.y() - lower.y()) * (upper.x() - lower.x());
            double const column = std::ceil((x - low_.x()) / cell_ - 0.5);
            flip_from(&cells.bits[word_of(row - cells.first_row, 0)],
                      static_cast<int>(std::clamp(column, 0.0, double { kCells })));
        }
    }
    for (auto const word : cells.bits)
        cells.count += static_cast<std::size_t>(std::popcount(word));
    return cells;
}

std::size_t CoverageGrid::count_covered(Cells const& cells) const
{
    std::size_t count = 0;
    auto const first = word_of(cells.first_row, 0);
    for (std::size_t i = 0; i < cells.bits.size(); ++i)
        count += static_cast<std::size_t>(std::popcount(cells.bits[i] & covered_[first + i]));
    return count;
}

void CoverageGrid::cover(Cells const& cells)
{
    auto const first = word_of(cells.first_row, 0);
    for (std::size_t i = 0; i < cells.bits.size(); ++i)
        covered_[first + i] |= cells.bits[i];
}

double CoverageGrid::coverage() const
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < whole_.size(); ++i)
        count += static_cast<std::size_t>(std::popcount(whole_[i] & covered_[i]));
    return whole_count_ == 0 ? 0 : static_cast<double>(count) / static_cast<double>(whole_count_);
}

int CoverageGrid::row_of(Vec2 const& point) const
{
    return static_cast<int>(std::floor((point.y() - low_.y()) / cell_));
}

int CoverageGrid::column_of(Vec2 const& point) const
{
    return static_cast<int>(std::floor((point.x() - low_.x()) / cell_));
}

bool CoverageGrid::is_inside(Vec2 const& point) const
{
    int const row = row_of(point);
    int const column = column_of(point);
    return row >= 0 && row < rows_ && column >= 0 && column < kCells && bit_at(whole_, row, column);
}

bool CoverageGrid::is_free(Vec2 const& point) const
{
    return is_inside(point) && !bit_at(covered_, row_of(point), column_of(point));
}

// Chamfer distance transform with weights 5 (edge neighbours) and 7 (corner neighbours) (Borgefors
// 1986).
CoverageGrid::Gap CoverageGrid::widest_gap(int step) const
{
    // Cells per row and per column of the search, with a border of cells that count as covered.
    int const size = kCells / step + 2;
    constexpr std::uint16_t kFar = 60'000;
    std::vector<std::uint16_t> far(static_cast<std::size_t>(size * size), 0);
    int const rows = (rows_ - 1) / step;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column + 1 < size - 1; ++column) {
            bool const free = bit_at(whole_, row * step, column * step)
                && !bit_at(covered_, row * step, column * step);
            far[static_cast<std::size_t>((row + 1) * size + column + 1)] = free ? kFar : 0;
        }
    auto const relax = [&](int cell, std::array<int, 4> const& before) {
        auto& value = far[static_cast<std::size_t>(cell)];
        for (std::size_t i = 0; i < before.size() && value > 0; ++i)
            value
                = std::min(value,
                           static_cast<std::uint16_t>(
                               far[static_cast<std::size_t>(cell + before[i])] + (i < 2 ? 5 : 7)));
    };
    int best = 0;
    for (int row = 1; row <= rows; ++row)
        for (int column = 1; column < size - 1; ++column)
            relax(row * size + column, { -1, -size, -size - 1, -size + 1 });
    for (int row = rows; row >= 1; --row)
        for (int column = size - 2; column >= 1; --column) {
            int const cell = row * size + column;
            relax(cell, { 1, size, size + 1, size - 1 });
            if (far[static_cast<std::size_t>(cell)] > far[static_cast<std::size_t>(best)])
                best = cell;
        }
    Vec2 const at((best % size - 1) * step + 0.5, (best / size - 1) * step + 0.5);
    return { low_ + cell_ * at, far[static_cast<std::size_t>(best)] / 5.0 * step * cell_ };
}

} // namespace tractus::silhouette
