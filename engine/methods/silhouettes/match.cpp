#include "engine/methods/silhouettes/match.h"

#include <algorithm>
#include <bit>
#include <tuple>

namespace tractus::silhouette {

namespace {

std::size_t shared_cells(CoverageGrid::Cells const& a, CoverageGrid::Cells const& b)
{
    constexpr int kRowWords = CoverageGrid::kCells / 64;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.bits.size(); ++i) {
        auto const other = static_cast<std::ptrdiff_t>(i) + (a.first_row - b.first_row) * kRowWords;
        if (other >= 0 && other < static_cast<std::ptrdiff_t>(b.bits.size()))
            count += static_cast<std::size_t>(
                std::popcount(a.bits[i] & b.bits[static_cast<std::size_t>(other)]));
    }
    return count;
}

std::vector<CoverageGrid::Cells> crowns_of(CoverageGrid const& grid, BranchingSystem const& system)
{
    std::vector<CoverageGrid::Cells> crowns;
    for (auto const& branch : system.branches)
        crowns.push_back(grid.cells_of(branch.crown));
    return crowns;
}

// Intersection of two areas as a share of the larger one.
double shared_area(CoverageGrid::Cells const& a, CoverageGrid::Cells const& b)
{
    auto const larger = std::max(a.count, b.count);
    return larger == 0 ? 0 : static_cast<double>(shared_cells(a, b)) / static_cast<double>(larger);
}

// True if branches of these origins may match: a drawn branch may match the inferred branch of the
// bump in which it ends.
bool may_be_one(Branch::Origin one, Branch::Origin other)
{
    auto const is_of_bump = [](Branch::Origin origin) {
        return origin == Branch::Origin::Bump || origin == Branch::Origin::Drawn;
    };
    return one == other || (is_of_bump(one) && is_of_bump(other));
}

} // namespace

std::vector<std::optional<std::size_t>> match_branches(BranchingSystem const& earlier,
                                                       BranchingSystem const& later)
{
    constexpr double kMin = 0.5;
    // Cost of a pair with the same stroke: below all other costs, so these pairs match first.
    constexpr double kSameStroke = -2;
    auto both = earlier.outline;
    both.insert(both.end(), later.outline.begin(), later.outline.end());
    CoverageGrid const grid(both);
    auto const before = crowns_of(grid, earlier);
    auto const after = crowns_of(grid, later);
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
    for (std::size_t j = 0; j < after.size(); ++j)
        for (std::size_t i = 0; i < before.size(); ++i)
            if (may_be_one(earlier.branches[i].origin, later.branches[j].origin)) {
                double const share = shared_area(before[i], after[j]);
                if (share >= kMin)
                    pairs.emplace_back(-share, j, i);
            }
    // Branches drawn by one and the same stroke always match, even where their parents have moved.
    for (std::size_t j = 0; j < after.size(); ++j)
        for (std::size_t i = 0; i < before.size(); ++i)
            if (earlier.branches[i].is_stroke() && later.branches[j].is_stroke()
                && earlier.branches[i].stroke == later.branches[j].stroke)
                pairs.emplace_back(kSameStroke, j, i);
    std::sort(pairs.begin(), pairs.end());
    std::vector<std::optional<std::size_t>> partners(after.size());
    std::vector<bool> taken(before.size(), false);
    for (auto const& [share, j, i] : pairs) {
        if (partners[j] || taken[i])
            continue;
        partners[j] = i;
        taken[i] = true;
    }
    return partners;
}

} // namespace tractus::silhouette
