#include "engine/methods/silhouettes/arrangement.h"

#include "engine/methods/silhouettes/crown_surface.h"
#include "tests/engine/methods/silhouettes/outlines.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <vector>

namespace tractus::silhouette {
namespace {

constexpr std::uint32_t kSeeds = 24;

double apart(Place const& a, Place const& b)
{
    auto const wrapped = [](double d) { return d - std::round(d); };
    return std::hypot(wrapped(a.u - b.u), wrapped((a.theta_deg - b.theta_deg) / 360));
}

struct Spacing {
    double clark_evans = 0; // Clark-Evans index: 1 for random points, and at most 2.15.
    double variation = 0;
};

// Returns the spacing of places, computed from nearest-neighbour distances on the unrolled parent
// (Clark and Evans, 1954).
Spacing spacing_of(std::vector<Place> const& places)
{
    double sum = 0;
    double squares = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < places.size(); ++j)
            if (j != i)
                nearest = std::min(nearest, apart(places[i], places[j]));
        sum += nearest;
        squares += nearest * nearest;
    }
    auto const n = static_cast<double>(places.size());
    double const mean = sum / n;
    return { mean * 2 * std::sqrt(n), std::sqrt(squares / n - mean * mean) / mean };
}

Spacing mean_spacing(ArrangementOptions const& options, std::vector<DrawnPlace> const& drawn = {})
{
    Spacing mean;
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        auto const result = arrange(drawn, options, { .seed = seed });
        EXPECT_LE(result.cost_after, result.cost_before);
        auto const spacing = spacing_of(result.places);
        mean.clark_evans += spacing.clark_evans / kSeeds;
        mean.variation += spacing.variation / kSeeds;
    }
    return mean;
}

// The expected values are those of the reference implementation: means over 24 seeds of another
// random generator.
TEST(SilhouetteArrangement, SpreadsAsFarAsTheReference)
{
    auto const spacing = [](std::size_t count, std::optional<double> alpha) {
        return mean_spacing({ .count = count, .alpha = alpha });
    };
    EXPECT_NEAR(spacing(12, 20).clark_evans, 1.77, 0.08);
    EXPECT_NEAR(spacing(30, 20).clark_evans, 1.44, 0.08);
    EXPECT_NEAR(spacing(30, {}).clark_evans, 1.60, 0.08);
    EXPECT_NEAR(spacing(60, {}).clark_evans, 1.53, 0.08);
    EXPECT_NEAR(spacing(30, {}).variation, 0.13, 0.05);
    EXPECT_GT(spacing(30, {}).clark_evans, 1.3);
    // Without proposals there is no search, so the positions are random.
    EXPECT_NEAR(mean_spacing({ .count = 30, .proposals = 0 }).clark_evans, 1, 0.06);
}

TEST(SilhouetteArrangement, DrawnBranchesKeepTheirHeightAndSide)
{
    std::vector<DrawnPlace> const drawn { { 0.25, 180 }, { 0.4, 0 },    { 0.55, 180 },
                                          { 0.7, 0 },    { 0.82, 180 }, { 0.92, 0, 10 } };
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        auto const places = arrange(drawn, { .count = 30 }, { .seed = seed }).places;
        ASSERT_EQ(places.size(), 30U);
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            EXPECT_EQ(places[i].u, drawn[i].u);
            double const off = places[i].theta_deg - drawn[i].theta_deg;
            EXPECT_LE(std::fabs(off - 360 * std::round(off / 360)), drawn[i].most_off_deg + 1e-9);
        }
        for (auto const& place : places) {
            EXPECT_GE(place.theta_deg, 0);
            EXPECT_LT(place.theta_deg, 360);
            EXPECT_GE(place.u, 0);
            EXPECT_LE(place.u, 1);
        }
    }
    EXPECT_NEAR(mean_spacing({ .count = 30, .alpha = 20 }, drawn).clark_evans, 1.40, 0.1);
}

TEST(SilhouetteArrangement, PerfectPatternsHaveNoMisfit)
{
    struct Case {
        Pattern pattern;
        int whorl;
        double turn_deg;
    };
    std::vector<Case> cases { { Pattern::Spiral, 1, 144 },
                              { Pattern::Decussate, 2, 90 },
                              { Pattern::Whorls, 3, 60 },
                              { Pattern::TwoRows, 1, 180 },
                              { Pattern::Horizontal, 2, 0 } };
    for (int whorl = kMinWhorl; whorl <= kMaxWhorl; ++whorl)
        cases.push_back({ Pattern::whorls_of(whorl), whorl, 180.0 / whorl });
    for (auto const& [pattern, whorl, turn_deg] : cases) {
        constexpr int kNodes = 12;
        std::vector<Place> places;
        for (int node = 0; node < kNodes; ++node)
            for (int w = 0; w < whorl; ++w)
                places.push_back(
                    { (node + 0.5) / kNodes, std::fmod(node * turn_deg + w * 360.0 / whorl, 360) });
        double const apart_u = node_distance(pattern, places.size());
        EXPECT_DOUBLE_EQ(apart_u, 1.0 / kNodes);
        for (std::size_t i = 0; i < places.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_NEAR(misfit(pattern, apart_u, places[i], places[j]), 0, 1e-9);
        EXPECT_NEAR(misfit(pattern, apart_u, { 0.2, 0 }, { 0.2, 180.0 / whorl }), 0.5, 1e-9);
    }
}

TEST(SilhouetteArrangement, PatternsComeOut)
{
    for (Pattern const pattern : { Pattern(Pattern::Spiral), Pattern(Pattern::Decussate),
                                   Pattern(Pattern::Whorls), Pattern::whorls_of(4) }) {
        double sum = 0;
        double pairs = 0;
        for (std::uint32_t seed = 0; seed < 8; ++seed) {
            auto const places = arrange({},
                                        { .pattern = pattern,
                                          .count = 24,
                                          .alpha = 20,
                                          .nodes = ArrangementOptions::Nodes::Free },
                                        { .seed = seed })
                                    .places;
            for (std::size_t i = 0; i < places.size(); ++i)
                for (std::size_t j = 0; j < i; ++j, ++pairs)
                    sum += misfit(pattern, node_distance(pattern, 24), places[i], places[j]);
        }
        // For random positions, the mean would be 1/4.
        EXPECT_LT(sum / pairs, 0.06) << name_of(pattern);
        auto const snapped = arrange({}, { .pattern = pattern, .count = 24 }, { .seed = 1 }).places;
        for (auto const& place : snapped) {
            double const nodes = place.u / node_distance(pattern, 24) - 0.5;
            EXPECT_NEAR(nodes, std::round(nodes), 1e-9);
        }
    }
}

// The search must find whorls of five, in which neighbours at a node are nearly a fifth of a turn
// apart.
TEST(SilhouetteArrangement, WhorlsHaveTheirBranches)
{
    constexpr int kWhorl = 5;
    auto const pattern = Pattern::whorls_of(kWhorl);
    auto const places = arrange({}, { .pattern = pattern, .count = 25 }, { .seed = 4 }).places;
    std::map<int, std::vector<double>> thetas_at;
    for (auto const& place : places)
        thetas_at[static_cast<int>(place.u / node_distance(pattern, 25))].push_back(
            place.theta_deg);
    EXPECT_EQ(thetas_at.size(), 5u);
    // Sum of the deviations of the angles between branches from multiples of a fifth of a turn.
    double of_gap = 0;
    double pairs = 0;
    for (auto& [node, thetas] : thetas_at)
        for (std::size_t i = 0; i < thetas.size(); ++i)
            for (std::size_t j = 0; j < i; ++j, ++pairs) {
                double const gaps = (thetas[i] - thetas[j]) / (360.0 / kWhorl);
                of_gap += std::fabs(gaps - std::round(gaps));
            }
    EXPECT_LT(of_gap / pairs, 0.06); // For random angles, the mean would be 1/4.
}

using Nodes = ArrangementOptions::Nodes;

// Returns the number of branches at each node, from the lowest node up.
std::vector<std::size_t> sizes_of_nodes(std::vector<Place> const& places)
{
    std::map<double, std::size_t> at;
    for (auto const& place : places)
        ++at[place.u];
    std::vector<std::size_t> sizes;
    for (auto const& [u, size] : at)
        sizes.push_back(size);
    return sizes;
}

// Returns the expected number of branches at each node: `whorl`, and the remainder at the last
// node.
std::vector<std::size_t> whole_nodes(std::size_t whorl, std::size_t count)
{
    std::vector<std::size_t> sizes(count / whorl, whorl);
    if (count % whorl > 0)
        sizes.push_back(count % whorl);
    return sizes;
}

double mean_misfit(Pattern pattern, double node, std::vector<Place> const& places)
{
    double sum = 0;
    double pairs = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j, ++pairs)
            sum += misfit(pattern, node, places[i], places[j]);
    return sum / pairs;
}

TEST(SilhouetteArrangement, NoNodeIsTorn)
{
    for (Pattern const pattern :
         { Pattern(Pattern::Spiral), Pattern(Pattern::TwoRows), Pattern(Pattern::Decussate),
           Pattern(Pattern::Whorls), Pattern(Pattern::Horizontal), Pattern::whorls_of(2),
           Pattern::whorls_of(5), Pattern::whorls_of(12) })
        for (std::size_t const count : { 6u, 12u, 24u, 25u, 31u, 60u })
            for (std::uint32_t seed = 0; seed < 16; ++seed) {
                SCOPED_TRACE(fmt::format("{}, {} of seed {}", describe(pattern), count, seed));
                auto const result
                    = arrange({}, { .pattern = pattern, .count = count }, { .seed = seed });
                EXPECT_EQ(sizes_of_nodes(result.places), whole_nodes(node_size(pattern), count));
                EXPECT_LE(result.cost_after, result.cost_before);
                EXPECT_LT(mean_misfit(pattern, node_distance(pattern, count), result.places), 0.06);
            }
    // In older trees, branches snap to nodes. Whorls may then be incomplete.
    auto const torn = arrange({}, { .pattern = Pattern::Whorls, .count = 24, .nodes = Nodes::Snap },
                              { .seed = 1 });
    EXPECT_NE(sizes_of_nodes(torn.places), whole_nodes(3, 24));
}

// The branches at an incomplete node must be spread all around the parent.
TEST(SilhouetteArrangement, ALastWhorlIsSpread)
{
    auto const places
        = arrange({}, { .pattern = Pattern::whorls_of(12), .count = 15 }, { .seed = 2 }).places;
    std::vector<double> last;
    for (auto const& place : places)
        if (place.u == 1)
            last.push_back(place.theta_deg);
    ASSERT_EQ(last.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        double const away_deg = std::fabs(last[i] - last[(i + 1) % 3]);
        EXPECT_GE(std::min(away_deg, 360 - away_deg), 90 - 1e-9);
    }
}

// Most of the drawn branches snap to nodes. One was drawn by hand, and defines a node.
TEST(SilhouetteArrangement, WholeWhorlsHaveTheDrawnBranches)
{
    std::vector<DrawnPlace> drawn;
    for (int i = 0; i < 12; ++i)
        drawn.push_back({ .u = 0.3 + 0.05 * i,
                          .theta_deg = i % 2 == 0 ? 0.0 : 180.0,
                          .most_off_deg = 30,
                          .keeps_u = i == 5 });
    for (Pattern const pattern :
         { Pattern(Pattern::Spiral), Pattern(Pattern::TwoRows), Pattern(Pattern::Decussate),
           Pattern(Pattern::Whorls), Pattern::whorls_of(5) })
        for (std::uint32_t seed = 0; seed < 16; ++seed) {
            SCOPED_TRACE(fmt::format("{}, seed {}", describe(pattern), seed));
            auto const places = arrange(drawn, { .pattern = pattern, .count = 30, .first_u = 0.3 },
                                        { .seed = seed })
                                    .places;
            EXPECT_EQ(sizes_of_nodes(places), whole_nodes(node_size(pattern), 30));
            EXPECT_EQ(places[5].u, drawn[5].u);
            double const node = 0.7 * node_distance(pattern, 30);
            for (std::size_t i = 0; i < drawn.size(); ++i) {
                double const off_deg = places[i].theta_deg - drawn[i].theta_deg;
                EXPECT_LE(std::fabs(off_deg - 360 * std::round(off_deg / 360)), 30 + 1e-9);
                EXPECT_LT(std::fabs(places[i].u - drawn[i].u), 2 * node);
            }
        }
}

// Older trees must not change. The expected values were computed by the version before complete
// whorls.
TEST(SilhouetteArrangement, SnapsAsItDidAtFirst)
{
    auto const places
        = arrange({}, { .pattern = Pattern::Whorls, .count = 6, .nodes = Nodes::Snap },
                  { .seed = 3 })
              .places;
    std::vector<Place> const before { { 0.75, 242.48606132113946 }, { 0.25, 56.955734853875455 },
                                      { 0.25, 359.5609050497545 },  { 0.25, 180.68068454118847 },
                                      { 0.75, 118.80649044059012 }, { 0.25, 298.7048589014941 } };
    ASSERT_EQ(places.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(places[i].u, before[i].u);
        EXPECT_DOUBLE_EQ(places[i].theta_deg, before[i].theta_deg);
    }
}

TEST(SilhouetteArrangement, HorizontalPairsLieInThePlane)
{
    auto const places
        = arrange({}, { .pattern = Pattern::Horizontal, .count = 20 }, { .seed = 3 }).places;
    for (auto const& place : places)
        EXPECT_TRUE(place.theta_deg == 0 || place.theta_deg == 180);
}

TEST(SilhouetteArrangement, PatternsHaveWords)
{
    for (auto const* const word :
         { "even", "spiral", "decussate", "whorls", "two-rows", "horizontal" }) {
        ASSERT_TRUE(pattern_of(word)) << word;
        EXPECT_STREQ(name_of(*pattern_of(word)), word);
    }
    EXPECT_FALSE(pattern_of("heap"));
    EXPECT_EQ(describe(Pattern::Whorls), "whorls");
    EXPECT_EQ(describe(Pattern::whorls_of(7)), "whorls of 7");
    EXPECT_EQ(describe(Pattern::Even), "even");
}

// The crown extends 40 to the right and 20 to the left. Its expected radii are the published ones.
TEST(SilhouetteSurface, TurnsFromOneHalfToTheOther)
{
    std::vector<Vec2> const outline { Vec2(0, 0),   Vec2(40, 0),    Vec2(40, 100),
                                      Vec2(0, 100), Vec2(-20, 100), Vec2(-20, 0) };
    auto const dense = resampled_outline(outline, 600);
    CrownSurface const surface(dense, upright(-20, 90));
    EXPECT_NEAR(surface.at(0.5, 0).x(), 40, 0.5);
    EXPECT_NEAR(surface.at(0.5, 60).x(), 35, 0.5);
    EXPECT_NEAR(surface.at(0.5, 90).x(), 30, 0.5);
    EXPECT_NEAR(surface.at(0.5, 120).x(), 25, 0.5);
    EXPECT_NEAR(surface.at(0.5, 180).x(), 20, 0.5);
}

} // namespace
} // namespace tractus::silhouette
