// Tests of compound leaves that are drawn leaflet by leaflet along a rachis.
#include "engine/methods/leaves/derived_outline.h"
#include "engine/methods/leaves/drawn_leaf.h"
#include "engine/methods/leaves/leaf_sketch.h"
#include "engine/methods/leaves/print_grammar.h"
#include "tests/engine/methods/drawn_by_hand.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

namespace tractus::leaf {
namespace {

constexpr double kHandTremor_mm = 0.1;

// A compound leaf as it is meant. Its petiole begins at (0, 0) and points to (0, 1).
struct MeantLeaf {
    struct Leaflet {
        Vec2 base;
        double heading_deg = 0; // Clockwise from up.
        double size_mm = 30;
        bool is_end = false;
    };
    FlatLine rachis {};
    std::vector<Leaflet> leaflets {};
    double width = 0.45; // Width of a leaflet as a share of its length.
    double low = 0.8;    // Below 1: leaflets are widest below their middle.
    bool has_midribs = false;
};

Vec2 heading(double deg)
{
    return { std::sin(radians(deg)), std::cos(radians(deg)) };
}

FlatLine outline_of(MeantLeaf const& leaf, MeantLeaf::Leaflet const& leaflet)
{
    Vec2 const along = heading(leaflet.heading_deg);
    Vec2 const right(along.y(), -along.x());
    FlatLine ring;
    constexpr int kPoints = 60;
    for (int i = 0; i < 2 * kPoints; ++i) {
        double const y = i <= kPoints ? double(i) / kPoints : 2 - double(i) / kPoints;
        double const x = (i <= kPoints ? 0.5 : -0.5) * leaf.width
            * std::pow(std::sin(kPi * std::pow(y, leaf.low)), 0.8);
        ring.push_back(leaflet.base + leaflet.size_mm * (x * right + y * along));
    }
    return ring;
}

// Returns a leaf of random pairs of leaflets, opposite or alternate, with or without a leaflet at
// the end, along a bowed rachis.
MeantLeaf random_leaf(tractus::Hand& hand)
{
    MeantLeaf leaf { .width = hand.between(0.35, 0.6), .low = hand.between(0.7, 1) };
    leaf.has_midribs = hand.chance(0.5);
    auto const pairs = static_cast<int>(2 + hand.below(5));
    double const size_mm = hand.between(25, 45);
    double const gap_mm = size_mm * leaf.width * hand.between(1.05, 1.4);
    double const petiole_mm = hand.between(15, 40);
    double const length_mm = petiole_mm + gap_mm * (pairs + 0.3);
    double const bow_deg = hand.between(-25, 25);
    bool const is_alternate = hand.chance(0.4);
    bool const has_end = hand.chance(0.7);
    // The rachis is straight up to the first leaflet.
    auto const turn_deg = [&](double at_mm) {
        return bow_deg * std::max(0.0, at_mm - petiole_mm) / (length_mm - petiole_mm);
    };
    Vec2 at = Vec2::Zero();
    std::vector<Vec2> places;
    constexpr double kStep_mm = 0.25;
    for (double mm = 0; mm <= length_mm; mm += kStep_mm) {
        leaf.rachis.push_back(at);
        places.push_back(at);
        at += kStep_mm * heading(turn_deg(mm));
    }
    for (int pair = 0; pair < pairs; ++pair)
        for (double const side : { 1.0, -1.0 }) {
            double const mm
                = petiole_mm + gap_mm * pair + (is_alternate && side < 0 ? 0.5 * gap_mm : 0);
            double const angle_deg = hand.between(45, 65);
            double const stalk_mm = hand.between(0.5, 4);
            double const heading_deg = turn_deg(mm) + side * angle_deg;
            leaf.leaflets.push_back(
                { places[static_cast<std::size_t>(mm / kStep_mm)] + stalk_mm * heading(heading_deg),
                  heading_deg, size_mm * hand.between(0.75, 1.1) });
        }
    if (has_end)
        leaf.leaflets.push_back({ leaf.rachis.back() + 1.5 * heading(bow_deg),
                                  bow_deg + hand.between(-8, 8), size_mm * 1.15, true });
    return leaf;
}

std::vector<Vec3> in_space(FlatLine const& line)
{
    std::vector<Vec3> points;
    for (auto const& at : line)
        points.emplace_back(at.x(), at.y(), 0);
    return points;
}

// Draws the leaf with a trembling hand: the rachis first, then one leaflet after the other, or all
// in any order; each line in any direction.
LeafDrawing drawn(MeantLeaf const& leaf, tractus::Hand& hand, bool shuffles)
{
    LeafDrawing drawing;
    auto const add = [&](FlatLine const& line) {
        auto points = in_space(line);
        if (hand.chance(0.5))
            std::ranges::reverse(points);
        drawing.strokes.push_back(hand.draw(points, kHandTremor_mm));
    };
    add(leaf.rachis);
    for (auto const& leaflet : leaf.leaflets) {
        auto ring = outline_of(leaf, leaflet);
        ring.push_back(ring.front());
        add(ring);
        Vec2 const way = leaflet.size_mm * heading(leaflet.heading_deg);
        if (leaf.has_midribs)
            add({ leaflet.base, leaflet.base + 0.5 * way, leaflet.base + 0.97 * way });
    }
    if (shuffles)
        hand.shuffle(drawing.strokes);
    return drawing;
}

std::vector<FlatLine> meant_outlines(MeantLeaf const& leaf)
{
    std::vector<FlatLine> rings;
    for (auto const& leaflet : leaf.leaflets)
        rings.push_back(outline_of(leaf, leaflet));
    return rings;
}

std::vector<FlatLine> moved(std::vector<FlatLine> rings, double scale, double turn_deg,
                            Vec2 const& by)
{
    Eigen::Rotation2Dd const turn(radians(turn_deg));
    for (auto& ring : rings)
        for (auto& at : ring)
            at = turn * (scale * at) + by;
    return rings;
}

// Overlap of the leaf that a grammar derives with the one that was meant, after the best small
// movement: where the petiole begins, and at which angle, is drawn by a trembling hand, too.
double overlap_with_meant(LeafFit const& fit, MeantLeaf const& leaf)
{
    auto const derived = derived_leaflets(fit.leaf);
    EXPECT_TRUE(derived) << (derived ? "" : derived.error().message);
    auto const meant = meant_outlines(leaf);
    double turn_deg = 0;
    Vec2 by = Vec2::Zero();
    auto const overlap = [&](double angle, Vec2 const& move) {
        return overlap_of(moved(*derived, fit.leaf.size_mm, angle, move), meant);
    };
    double best = overlap(turn_deg, by);
    for (double step = 1; step > 0.2; step /= 2)
        for (bool is_better = true; std::exchange(is_better, false);)
            for (auto const& [more_deg, more] :
                 { std::pair { step, Vec2(0, 0) }, std::pair { -step, Vec2(0, 0) },
                   std::pair { 0.0, Vec2(step, 0) }, std::pair { 0.0, Vec2(-step, 0) },
                   std::pair { 0.0, Vec2(0, step) }, std::pair { 0.0, Vec2(0, -step) } })
                if (double const found = overlap(turn_deg + more_deg, by + more); found > best) {
                    best = found;
                    turn_deg += more_deg;
                    by += more;
                    is_better = true;
                }
    return best;
}

LeafFit fitted(LeafDrawing const& drawing)
{
    auto const seen = recognise_leaf(drawing);
    EXPECT_TRUE(seen) << (seen ? "" : seen.error().message);
    auto const fit = fit_leaf(seen.value_or(RecognisedLeaf {}));
    EXPECT_TRUE(fit) << (fit ? "" : fit.error().message);
    return fit.value_or(LeafFit {});
}

TEST(CompoundLeaf, ComesBackFromFiftyDrawings)
{
    constexpr int kLeaves = 50;
    int well = 0;
    double worst = 1;
    double worst_reported = 0; // Difference between reported and actual overlap.
    for (int i = 0; i < kLeaves; ++i) {
        tractus::Hand hand(static_cast<std::uint64_t>(i) + 1);
        auto const leaf = random_leaf(hand);
        auto const drawing = drawn(leaf, hand, i % 2 == 1);
        auto const seen = recognise_leaf(drawing);
        ASSERT_TRUE(seen) << i << ": " << seen.error().message;
        auto const fit = fit_leaf(*seen);
        ASSERT_TRUE(fit) << i << ": " << fit.error().message;
        bool const has_end = leaf.leaflets.back().is_end;
        EXPECT_EQ(fit->leaf.leaflets.size(), leaf.leaflets.size() - (has_end ? 1 : 0)) << i;
        EXPECT_EQ(fit->leaf.end.size > 0, has_end) << i;
        EXPECT_EQ(std::ranges::count(seen->roles, StrokeRole::Rachis), 1) << i;
        EXPECT_EQ(std::ranges::count(seen->roles, StrokeRole::Midrib),
                  leaf.has_midribs ? static_cast<int>(leaf.leaflets.size()) : 0)
            << i;
        double const overlap = overlap_with_meant(*fit, leaf);
        double const reported = overlap_with_drawing(*seen, *fit).value();
        worst = std::min(worst, overlap);
        worst_reported = std::max(worst_reported, std::abs(reported - overlap));
        well += overlap >= 0.95 ? 1 : 0;
        if (overlap < 0.95)
            std::printf("leaf %d: overlap %.4f, reported %.4f, %zu leaflets\n", i, overlap,
                        reported, leaf.leaflets.size());
    }
    std::printf("compound leaves: %d of %d overlap by 0.95, the worst by %.4f; reported within "
                "%.4f\n",
                well, kLeaves, worst, worst_reported);
    EXPECT_GE(well, 40);
    EXPECT_GE(worst, 0.9);
    EXPECT_LE(worst_reported, 0.05);
}

TEST(CompoundLeaf, HasTheAnglesAndSizesThatWereDrawn)
{
    MeantLeaf leaf;
    for (int i = 0; i <= 100; ++i)
        leaf.rachis.emplace_back(0, i);
    for (double const y : { 30.0, 55.0, 80.0 })
        for (double const side : { 1.0, -1.0 })
            leaf.leaflets.push_back({ Vec2(side * 3, y), side * 60, 30 });
    leaf.leaflets.push_back({ Vec2(0, 102), 0, 40, true });
    tractus::Hand hand(5);
    auto const fit = fitted(drawn(leaf, hand, false));
    ASSERT_EQ(fit.leaf.leaflets.size(), 6U);
    EXPECT_NEAR(fit.leaf.size_mm, 40, 1);
    for (std::size_t i = 0; i < 6; ++i) {
        auto const& leaflet = fit.leaf.leaflets[i];
        EXPECT_NEAR(std::abs(leaflet.angle_deg), 60, 4) << i;
        EXPECT_NEAR(leaflet.size, 0.75, 0.03) << i;
    }
    EXPECT_NEAR(fit.leaf.end.size, 1, 0.03);
    EXPECT_NEAR(fit.leaf.end.angle_deg, 0, 5);
}

TEST(CompoundLeaf, PrintsAsAGrammarThatGivesTheSameNumbers)
{
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        tractus::Hand hand(seed);
        auto const leaf = fitted(drawn(random_leaf(hand), hand, false)).leaf;
        auto const text = print_grammar(leaf, "compound");
        auto const grammar = parse_grammar(text, "drawn.leaf");
        ASSERT_TRUE(grammar) << grammar.error().message << "\n" << text;
        auto const again = read_drawn_leaf(*grammar);
        ASSERT_TRUE(again.has_value()) << text;
        EXPECT_EQ(*again, leaf) << text;
        EXPECT_EQ(print_grammar(*again, "compound"), text);
    }
}

TEST(CompoundLeaf, MayBePalmate)
{
    // Three leaflets around the end of a petiole, as of clover.
    MeantLeaf leaf { .width = 0.8, .low = 1.1, .has_midribs = true };
    for (int i = 0; i <= 50; ++i)
        leaf.rachis.emplace_back(0, i);
    leaf.leaflets = { { Vec2(1, 49), 75, 20 }, { Vec2(-1, 49), -75, 20 }, { Vec2(0, 51), 0, 20 } };
    tractus::Hand hand(3);
    auto const drawing = drawn(leaf, hand, false);
    auto const seen = recognise_leaf(drawing).value();
    auto const fit = fit_leaf(seen).value();
    EXPECT_EQ(fit.leaf.leaflets.size(), 2U);
    EXPECT_GT(fit.leaf.end.size, 0);
    EXPECT_GT(overlap_with_drawing(seen, fit).value(), 0.93);
}

TEST(CompoundLeaf, SaysWhatIsMissingAndLeavesOldDrawingsAsTheyAre)
{
    MeantLeaf leaf;
    leaf.rachis = { Vec2(0, 0), Vec2(0, 30), Vec2(0, 60) };
    leaf.leaflets = { { Vec2(3, 30), 60, 30 }, { Vec2(-3, 30), -60, 30 } };
    tractus::Hand hand(1);
    auto drawing = drawn(leaf, hand, false);
    EXPECT_TRUE(recognise_leaf(drawing));
    auto without_rachis = drawing;
    without_rachis.strokes.erase(without_rachis.strokes.begin());
    EXPECT_NE(recognise_leaf(without_rachis).error().message.find("draw the rachis"),
              std::string::npos);
    drawing.may_be_compound = false;
    EXPECT_NE(recognise_leaf(drawing).error().message.find("are both closed"), std::string::npos);
}

TEST(CompoundLeaf, GrowsUnderThePenLeafletByLeaflet)
{
    tractus::Hand hand(7);
    MeantLeaf leaf;
    for (int i = 0; i <= 90; ++i)
        leaf.rachis.emplace_back(0, i);
    for (double const y : { 40.0, 70.0 })
        for (double const side : { 1.0, -1.0 })
            leaf.leaflets.push_back({ Vec2(side * 2, y), side * 60, 30 });
    auto const drawing = drawn(leaf, hand, false);
    for (bool const may_be_leaflet : { true, false }) {
        LeafSketch sketch { .scale = 1 };
        for (auto const& line : drawing.strokes) {
            std::vector<TipSample> tips;
            for (auto const& point : line)
                tips.push_back(
                    { .time = timestamp_ns(static_cast<std::int64_t>(tips.size()) * 5'000'000),
                      .position_mm = point,
                      .pressure = 0.5 });
            sketch = with_line(sketch,
                               { .id = sketch.lines.size() + 1,
                                 .stroke = { std::move(tips) },
                                 .may_be_leaflet = may_be_leaflet })
                         .value();
            EXPECT_TRUE(build_leaf(sketch)) << sketch.lines.size();
        }
        bool const is_compound = sketch.seen && sketch.seen->fit.leaf.is_compound();
        EXPECT_EQ(is_compound, may_be_leaflet);
        if (!is_compound)
            continue;
        EXPECT_EQ(sketch.seen->lines.leaflets.size(), 4U);
        // The plant lies where the leaf was drawn.
        auto const built = build_leaf(sketch).value();
        Eigen::AlignedBox3d box;
        for (auto const& at : built.plant.polygon_vertices_mm)
            box.extend(Vec3(at.cast<double>()));
        EXPECT_NEAR(box.sizes().x(), 2 * (2 + 30 * std::sin(radians(60))), 5);
        EXPECT_NEAR(box.max().z(), 88, 5);
    }
}

} // namespace
} // namespace tractus::leaf
