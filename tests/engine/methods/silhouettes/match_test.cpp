#include "engine/methods/silhouettes/match.h"

#include "tests/engine/methods/silhouettes/outlines.h"

namespace tractus::silhouette {
namespace {

// Returns the crown as redrawn: its outline is displaced by smooth waves of at most 3 % of the
// crown's size.
Drawing redrawn(Drawing drawing, std::uint32_t number)
{
    Random random({ 20, 3, number });
    double const size = 0.015 * box_of(drawing.outline[0]).diagonal();
    double const phase_x = random.uniform(0, 2 * kPi);
    double const phase_y = random.uniform(0, 2 * kPi);
    double const waves = 1 + std::floor(random.uniform(0, 6));
    auto& outline = drawing.outline[0];
    for (std::size_t i = 0; i < outline.size(); ++i) {
        double const along
            = waves * 2 * kPi * static_cast<double>(i) / static_cast<double>(outline.size());
        outline[i] += size * Vec2(std::sin(along + phase_x), std::sin(along + phase_y));
    }
    return drawing;
}

// Counts the strokes that stay on their branches: for ten crowns with twenty strokes each, and ten
// changes of each outline.
TEST(SilhouetteMatch, StrokesStayOnTheirBranches)
{
    int strokes = 0;
    int kept = 0;
    for (std::uint32_t tree = 0; tree < 10; ++tree) {
        auto const drawing = lobed_crown(4 + static_cast<int>(tree), -30, 210);
        auto const earlier = *infer_system(drawing);
        for (std::uint32_t change = 0; change < 10; ++change) {
            auto const later = *infer_system(redrawn(drawing, 10 * tree + change));
            auto const partners = match_branches(earlier, later);
            for (std::size_t i = 0; i < std::min<std::size_t>(2, earlier.branches.size()); ++i) {
                ++strokes;
                auto const found = std::find(partners.begin(), partners.end(), std::optional(i));
                if (found == partners.end())
                    continue;
                ++kept;
                auto const& branch
                    = later.branches[static_cast<std::size_t>(found - partners.begin())];
                // The old and the new branch must be in the same lobe: their ends are at most half
                // of the diagonal of the old branch's crown apart.
                EXPECT_LT((branch.path.curve.end - earlier.branches[i].path.curve.end).norm(),
                          box_of(earlier.branches[i].crown).diagonal() / 2);
            }
        }
    }
    EXPECT_EQ(strokes, 200);
    EXPECT_GE(kept, 190);
}

TEST(SilhouetteMatch, ASystemMatchesItself)
{
    auto const system = *infer_system(ellipse(40, 80));
    auto const partners = match_branches(system, system);
    for (std::size_t i = 0; i < partners.size(); ++i)
        EXPECT_EQ(partners[i], std::optional(i));
}

} // namespace
} // namespace tractus::silhouette
