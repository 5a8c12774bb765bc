// Leaves must be identifiable by their outlines alone. Each painted leaf is given the species of
// the most similar leaf in a reference set, and the result is compared with its true species.
#include "app/methods/leaves/leaf_library.h"
#include "engine/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <vector>

namespace tractus::leaf {
namespace {

using Descriptor = std::vector<std::complex<double>>;

// Returns how far the leaf extends from the middle of the picture in each direction. Narrow gaps,
// such as those eaten by larvae, are ignored.
std::vector<double> reaches(leaf::LeafPicture const& picture)
{
    // Opacity above which a pixel counts. It is low, since petioles are thinner than the pixels of
    // a small picture.
    constexpr float kThin = 0.3f;
    constexpr int kWays = 128;
    constexpr int kGap = 2; // Width of an ignored gap, in directions on each side.
    std::vector<double> far(kWays, 0);
    int const side = picture.side;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            if (picture.alpha[static_cast<std::size_t>(y * side + x)] < kThin)
                continue;
            Vec2 const away = Vec2(x + 0.5, y + 0.5) / side - Vec2(0.5, 0.5);
            double const turn = std::atan2(away.y(), away.x()) / (2 * kPi) + 1;
            auto& reach = far[static_cast<std::size_t>(turn * kWays) % kWays];
            reach = std::max(reach, away.norm());
        }
    std::vector<double> closed(kWays, 0);
    for (int i = 0; i < kWays; ++i)
        for (int j = -kGap; j <= kGap; ++j)
            closed[static_cast<std::size_t>(i)]
                = std::max(closed[static_cast<std::size_t>(i)],
                           far[static_cast<std::size_t>((i + j + kWays) % kWays)]);
    return closed;
}

// Returns Fourier descriptors of the leaf's extents by direction. The phases are included, since
// all leaves are upright.
Descriptor describe(leaf::LeafPicture const& picture)
{
    constexpr int kFrequencies = 24;
    auto const line = reaches(picture);
    Descriptor made;
    for (int frequency = 0; frequency <= kFrequencies; ++frequency) {
        std::complex<double> sum;
        for (std::size_t i = 0; i < line.size(); ++i)
            sum += line[i]
                * std::polar(1.0, -2 * kPi * frequency * double(i) / double(line.size()));
        made.push_back(sum / double(line.size()));
    }
    return made;
}

double difference(Descriptor const& a, Descriptor const& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::norm(a[i] - b[i]);
    return sum;
}

struct Drawn {
    int side = 64;
    double age = 0.5;
    int larvae = 0;
};

Descriptor draw(leaf::Grammar const& grammar, std::uint64_t seed, Drawn const& drawn)
{
    LeafLife const life { .age = drawn.age, .seed = seed };
    auto const grown = grow_leaf(grammar, life);
    EXPECT_TRUE(grown.has_value()) << grammar.name;
    auto options = paint_options(grammar, life);
    options.side = drawn.side;
    options.larvae.count = drawn.larvae;
    return describe(leaf::paint_leaf(grown->leaf, grown->triangles, options));
}

// Compares 200 varied leaves of each species with a reference set of 50 leaves of each species.
// Half of the varied leaves are drawn at 64 pixels, every fourth is eaten by larvae, and their ages
// range from mature to dead. The reference leaves are whole and mature.
TEST(LeafSpecies, AreNamedByTheirOutlines)
{
    constexpr std::size_t kKnown = 50;
    constexpr std::size_t kAsked = 200;
    auto const names = leaf_names();
    std::vector<leaf::Grammar> grammars;
    for (auto const& name : names)
        grammars.push_back(load_leaf_grammar(name).value());
    std::vector<Descriptor> known(names.size() * kKnown);
    parallel_for(known.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i)
            known[i] = draw(grammars[i / kKnown], 10'000 + i % kKnown, { i % 2 == 0 ? 64 : 128 });
    });
    std::vector<std::size_t> named(names.size() * kAsked);
    parallel_for(named.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i) {
            auto const seed = i % kAsked;
            auto const asked = draw(grammars[i / kAsked], seed,
                                    { .side = seed % 2 == 0 ? 64 : 128,
                                      .age = 0.35 + 0.65 * double(seed) / kAsked,
                                      .larvae = seed % 4 == 3 ? 2 : 0 });
            auto const best = std::ranges::min_element(
                known, {}, [&](Descriptor const& other) { return difference(asked, other); });
            named[i] = static_cast<std::size_t>(best - known.begin()) / kKnown;
        }
    });
    std::size_t all_right = 0;
    for (std::size_t species = 0; species < names.size(); ++species) {
        std::map<std::string, int> called;
        for (std::size_t i = 0; i < kAsked; ++i)
            ++called[names[named[species * kAsked + i]]];
        std::string row;
        for (auto const& [name, count] : called)
            row += fmt::format(" {} {}", name, count);
        fmt::print("{:<12}{}\n", names[species], row);
        auto const right = static_cast<std::size_t>(called[names[species]]);
        all_right += right;
        EXPECT_GE(right, kAsked * 9 / 10) << names[species];
    }
    EXPECT_GE(double(all_right), 0.95 * double(named.size()));
}

} // namespace
} // namespace tractus::leaf
