// Tests the conversion of a leaf drawn by pen into a grammar.
#include "engine/methods/leaves/derived_outline.h"
#include "engine/methods/leaves/drawn_leaf.h"
#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_drawing.h"
#include "engine/methods/leaves/print_grammar.h"
#include "tests/engine/methods/leaves/drawing_hand.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace tractus::leaf {
namespace {

constexpr int kDrawings = 25; // Number of drawings of each of the eight species.

struct Drawn {
    BotanicalLeaf truth;
    Manner manner;
    HandDrawing hand;
};

Drawn drawn_leaf(std::string const& species, std::uint32_t number)
{
    Random random({ .seed = 2024, .stream = 7, .substream = number });
    Drawn drawn;
    drawn.truth = botanical_leaf(species, random);
    double const way = random.uniform();
    // Each random number has a statement of its own, since the arguments of a call are evaluated in
    // unspecified order.
    drawn.manner.size_mm = random.uniform(60, 150);
    drawn.manner.bend_deg = random.uniform(0, 30);
    drawn.manner.turned_deg = random.uniform(0, 360);
    double const y_mm = random.uniform(-80, 80);
    drawn.manner.place_mm = Vec3(random.uniform(-80, 80), y_mm, 60);
    drawn.manner.outline = way < 0.6 ? Manner::Outline::Closed
        : way < 0.88                 ? Manner::Outline::Halves
                                     : Manner::Outline::OneHalf;
    drawn.manner.has_stalk = random.uniform() < 0.7;
    // The other half of the leaf is the mirror image of the drawn half.
    if (drawn.manner.outline == Manner::Outline::OneHalf)
        for (std::size_t i = 0; i < drawn.truth.left.size(); ++i)
            drawn.truth.left[i] = { -drawn.truth.right[i].x(), drawn.truth.right[i].y() };
    drawn.hand = draw_by_hand(drawn.truth, drawn.manner, random);
    return drawn;
}

// Statistics over the drawings of one species.
struct Figures {
    int leaves = 0;
    int exact = 0;
    double worst_angle = 0;
    double angle_sum = 0;
    int angles = 0;
    int far_off = 0; // Number of angles that are wrong by more than 3 degrees.
    int well = 0;    // Number of outlines that overlap by at least 0.97.
    double worst_overlap = 1;
    double overlap_sum = 0;
    double worst_bend = 0;
};

FlatLine scaled_ring(FlatLine ring, double scale)
{
    for (auto& at : ring)
        at *= scale;
    return ring;
}

FlatLine moved(FlatLine ring, double turn_deg, Vec2 const& by)
{
    Eigen::Rotation2Dd const turn(radians(turn_deg));
    for (auto& at : ring)
        at = turn * at + by;
    return ring;
}

// Returns the maximum overlap of two leaves over small displacements and rotations. In a drawing by
// hand, outline and midrib meet only to within two millimetres, which does not matter for their
// shapes.
double best_overlap(FlatLine const& a, FlatLine const& b)
{
    double turn_deg = 0;
    Vec2 by = Vec2::Zero();
    double best = overlap_of(a, b);
    for (double step = 1; step > 0.1; step /= 2)
        for (bool is_better = true; std::exchange(is_better, false);)
            for (auto const& [more_deg, more] :
                 { std::pair { step, Vec2(0, 0) }, std::pair { -step, Vec2(0, 0) },
                   std::pair { 0.0, Vec2(step, 0) }, std::pair { 0.0, Vec2(-step, 0) },
                   std::pair { 0.0, Vec2(0, step) }, std::pair { 0.0, Vec2(0, -step) } })
                if (double const overlap = overlap_of(moved(a, turn_deg + more_deg, by + more), b);
                    overlap > best) {
                    best = overlap;
                    turn_deg += more_deg;
                    by += more;
                    is_better = true;
                }
    return best;
}

bool has_all_veins(Drawn const& drawn, RecognisedLeaf const& seen, DrawnLeaf const& leaf)
{
    std::size_t const meant = drawn.truth.mains.size() + drawn.truth.sides.size();
    std::size_t found = leaf.mains.size() - 1;
    for (auto const& main : leaf.mains)
        for (auto const& knot : main.knots)
            found += (knot.right_deg ? 1u : 0u) + (knot.left_deg ? 1u : 0u);
    for (std::size_t i = 0; i < seen.roles.size(); ++i)
        if (seen.roles[i] != drawn.hand.meant[i].role)
            return false;
    return found == meant;
}

// Returns the error of a fitted vein's angle. For veins on the left of a half leaf, both angles are
// given as on the right.
double angle_off(LeafFit::Vein const& vein, BotanicalLeaf::Vein const& meant)
{
    return std::abs(std::remainder(vein.fitted_angle_deg - meant.angle_deg, 360));
}

void look_at(Drawn const& drawn, std::string const& name, Figures& figures)
{
    ++figures.leaves;
    auto const seen = recognise_leaf(drawn.hand.drawing);
    ASSERT_TRUE(seen.has_value()) << name << ": " << seen.error().message;
    auto const fit = fit_leaf(*seen);
    ASSERT_TRUE(fit.has_value()) << name << ": " << fit.error().message;
    bool const exact = has_all_veins(drawn, *seen, fit->leaf);
    figures.exact += exact ? 1 : 0;
    for (auto const& vein : fit->veins) {
        auto const* const meant = drawn.hand.meant[vein.stroke].vein;
        if (!meant)
            continue;
        double const off = angle_off(vein, *meant);
        figures.far_off += off > 3 ? 1 : 0;
        figures.worst_angle = std::max(figures.worst_angle, off);
        figures.angle_sum += off;
        ++figures.angles;
    }
    auto const derived = derived_outline(fit->leaf);
    ASSERT_TRUE(derived.has_value()) << name << ": " << derived.error().message;
    double const overlap = best_overlap(scaled_ring(*derived, fit->leaf.size_mm),
                                        scaled_ring(drawn.truth.margin(), drawn.manner.size_mm));
    figures.well += overlap >= 0.97 ? 1 : 0;
    figures.worst_overlap = std::min(figures.worst_overlap, overlap);
    figures.overlap_sum += overlap;
    figures.worst_bend
        = std::max(figures.worst_bend, std::abs(fit->leaf.bend_deg - drawn.manner.bend_deg));
}

TEST(DrawnLeaf, ComesBackFromTwoHundredDrawings)
{
    Figures all;
    std::printf("species   exact  angle mean worst >3 deg  overlap mean worst >=.97  bend worst\n");
    for (auto const& species : botanical_species()) {
        Figures figures;
        for (int i = 0; i < kDrawings; ++i)
            look_at(drawn_leaf(species, static_cast<std::uint32_t>(all.leaves + i)),
                    fmt::format("{}-{}", species, i), figures);
        std::printf("%-9s %4.0f %%  %10.2f %5.2f %2d/%3d  %12.4f %.4f %3.0f %%  %10.1f\n",
                    species.c_str(), 100.0 * figures.exact / figures.leaves,
                    figures.angle_sum / figures.angles, figures.worst_angle, figures.far_off,
                    figures.angles, figures.overlap_sum / figures.leaves, figures.worst_overlap,
                    100.0 * figures.well / figures.leaves, figures.worst_bend);
        all.leaves += figures.leaves;
        all.exact += figures.exact;
        all.angles += figures.angles;
        all.far_off += figures.far_off;
        all.well += figures.well;
        EXPECT_LE(figures.angle_sum, 1.0 * figures.angles) << species;
        EXPECT_GE(figures.overlap_sum, 0.97 * figures.leaves) << species;
    }
    EXPECT_GE(all.exact, 0.95 * all.leaves);
    EXPECT_LE(all.far_off, 0.01 * all.angles);
    // A willow leaf of 60 mm is narrower than 10 mm, so the tremor is a tenth of its width. In one
    // of the lime leaves, the tips of two veins cross, and the space between them stays empty.
    EXPECT_GE(all.well, 0.96 * all.leaves);
}

LeafFit fitted(std::string const& species, std::uint32_t number)
{
    auto const seen = recognise_leaf(drawn_leaf(species, number).hand.drawing);
    EXPECT_TRUE(seen.has_value());
    return fit_leaf(*seen).value();
}

// Returns the positions of all vertices of the leaf that a grammar derives, with its lamina filled.
std::vector<Vec3> derived_places(std::string const& text)
{
    auto const grammar = parse_grammar(text, "drawn.leaf");
    EXPECT_TRUE(grammar.has_value()) << grammar.error().message;
    auto leaf = Leaf::begin(*grammar, { .final_step = grammar->steps, .seed = 5 });
    for (int i = 0; i < grammar->steps; ++i)
        EXPECT_TRUE(leaf->derive().has_value());
    EXPECT_TRUE(leaf->fill().has_value());
    std::vector<Vec3> places;
    for (Vertex v = 0; v < static_cast<Vertex>(leaf->map().vertex_count()); ++v)
        places.push_back(leaf->map().position(v));
    return places;
}

TEST(DrawnLeaf, PrintsAsAGrammarThatGivesTheSameNumbersAndTheSameLeaf)
{
    for (auto const& species : botanical_species())
        for (std::uint32_t number = 0; number < 4; ++number) {
            auto const leaf = fitted(species, number).leaf;
            auto const text = print_grammar(leaf, species);
            auto const again = read_drawn_leaf(parse_grammar(text, "drawn.leaf").value());
            ASSERT_TRUE(again.has_value()) << text;
            EXPECT_EQ(print_grammar(*again, species), text);
            EXPECT_EQ(*again, leaf) << text;
            EXPECT_EQ(derived_places(print_grammar(*again, "another title")), derived_places(text));
        }
}

std::vector<Vec3> straight(Vec3 const& from, Vec3 const& to)
{
    std::vector<Vec3> line;
    for (int i = 0; i <= 40; ++i)
        line.push_back(from + i / 40.0 * (to - from));
    return line;
}

std::vector<Vec3> circle(Vec3 const& middle, double radius)
{
    std::vector<Vec3> line;
    for (int i = 0; i <= 100; ++i)
        line.push_back(
            middle + radius * Vec3(std::sin(2 * kPi * i / 100), -std::cos(2 * kPi * i / 100), 0));
    return line;
}

std::string refusal(std::vector<std::vector<Vec3>> const& strokes)
{
    auto const seen = recognise_leaf({ strokes });
    if (!seen)
        return seen.error().message;
    auto const fit = fit_leaf(*seen);
    return fit ? "" : fit.error().message;
}

TEST(DrawnLeaf, SaysWhatToDraw)
{
    auto const outline = circle({ 0, 0, 0 }, 40);
    auto const midrib = straight({ 0, -50, 0 }, { 0, 40, 0 });
    EXPECT_EQ(refusal({ outline, midrib }), "");
    EXPECT_NE(refusal({}).find("there are 0 strokes: draw an outline"), std::string::npos);
    EXPECT_NE(refusal({ outline }).find("there is no midrib: draw"), std::string::npos);
    EXPECT_NE(refusal({ midrib }).find("there is no outline: draw"), std::string::npos);
    EXPECT_NE(refusal({ outline, midrib, straight({ 5, 6, 7 }, { 5, 7, 7 }) })
                  .find("stroke 3 at (5, 6, 7) mm is too short"),
              std::string::npos);
    EXPECT_NE(refusal({ outline, midrib, straight({ 20, 0, 0 }, { 25, 8, 0 }) })
                  .find("stroke 3, which begins at (20, 0, 0) mm, begins on no vein"),
              std::string::npos);
    EXPECT_NE(refusal({ outline, midrib, circle({ 100, 0, 0 }, 30) })
                  .find("strokes 1 and 3 are both closed"),
              std::string::npos);
    EXPECT_NE(refusal({ outline, { Vec3(0, std::nan(""), 0), Vec3(1, 2, 3) } })
                  .find("stroke 2 has no points, or one that lies nowhere near"),
              std::string::npos);
}

TEST(DrawnLeaf, MayHaveParallelVeins)
{
    std::vector<Vec3> blade;
    for (int i = 0; i <= 200; ++i) {
        double const t = i / 100.0;
        double const y = 200 * (t <= 1 ? t : 2 - t);
        blade.emplace_back((t <= 1 ? 6 : -6) * std::pow(std::sin(kPi * y / 200), 0.4), y, 0);
    }
    std::vector<std::vector<Vec3>> strokes { blade, straight({ 0, -20, 0 }, { 0, 199, 0 }) };
    for (double const x : { -4, -2, 2, 4 })
        strokes.push_back(straight({ 0.1 * x, 1, 0 }, { x, 150, 0 }));
    auto const seen = recognise_leaf({ strokes });
    ASSERT_TRUE(seen.has_value()) << seen.error().message;
    auto const fit = fit_leaf(*seen);
    ASSERT_TRUE(fit.has_value());
    EXPECT_EQ(fit->leaf.mains.size(), 5u);
    auto const outline = derived_outline(fit->leaf);
    ASSERT_TRUE(outline.has_value()) << outline.error().message;
    EXPECT_GT(overlap_of(*outline, fit->outline), 0.97);
}

} // namespace
} // namespace tractus::leaf
