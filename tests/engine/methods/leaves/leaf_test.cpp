#include "engine/methods/leaves/leaf.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tractus::leaf {
namespace {

Grammar grammar_of(std::string const& text)
{
    auto grammar = parse_grammar(text, "test.leaf");
    EXPECT_TRUE(grammar.has_value()) << (grammar ? "" : grammar.error().message);
    return grammar ? *std::move(grammar) : Grammar {};
}

Leaf derived(Grammar const& grammar, int steps, int final_step)
{
    auto leaf = Leaf::begin(grammar, { .final_step = final_step });
    EXPECT_TRUE(leaf.has_value()) << (leaf ? "" : leaf.error().message);
    for (int i = 0; i < steps; ++i) {
        auto const done = leaf->derive();
        EXPECT_TRUE(done.has_value()) << (done ? "" : done.error().message);
        EXPECT_EQ(leaf->map().fault(), "") << "step " << i + 1;
    }
    return *std::move(leaf);
}

std::string const kPinnate = "#define A(4,1,0,0,90,2,0.2)\n"
                             "#define T(4,1,0,0,0,1,0.18)\n"
                             "#define K(4,1,0,0,0,0.2,0.18)\n"
                             "#define R(4,1,0,0,45,1,0.05)\n"
                             "#define L(4,1,0,0,-45,1,0.05)\n"
                             "#axiom : A\n"
                             "a A -> A[T]E\n"
                             "t T -> T[K[R(,,,,,3,)]C1[L(,,,,,3,)]C2[T]E]E\n";

// Each quad that grows on another quad adds eight darts, two vertices and three edges to the map.
TEST(Leaf, ATreeOfQuadsHasTheCellsOfOne)
{
    auto const grammar = grammar_of(kPinnate);
    auto leaf = derived(grammar, 0, 9);
    for (std::size_t step = 1; step <= 9; ++step) {
        ASSERT_TRUE(leaf.derive().has_value());
        auto const counts = leaf.map().counts();
        EXPECT_EQ(counts.faces, 4 * step - 2);
        EXPECT_EQ(counts.darts, 8 * counts.faces);
        EXPECT_EQ(counts.vertices, 2 * counts.faces + 2);
        EXPECT_EQ(counts.edges, 3 * counts.faces + 1);
        EXPECT_EQ(counts.euler_characteristic(), 1);
        EXPECT_EQ(counts.border_cycles, 1U);
    }
}

TEST(Leaf, TheLimbClosesTheWaysBetweenTips)
{
    auto const grammar = grammar_of(kPinnate);
    auto leaf = derived(grammar, 1, 9);
    for (int step = 2; step <= 9; ++step) {
        ASSERT_TRUE(leaf.derive().has_value());
        ASSERT_TRUE(leaf.fill().has_value());
        std::vector<int> sizes { 3, 3 };
        sizes.resize(static_cast<std::size_t>(2 * (step - 1)), 4);
        EXPECT_EQ(leaf.limb().sizes, sizes) << step;
        EXPECT_EQ(leaf.map().fault(), "") << step;
        EXPECT_EQ(leaf.map().counts().euler_characteristic(), 1) << step;
    }
}

TEST(Leaf, FillingTwiceIsFillingOnce)
{
    auto const grammar = grammar_of(kPinnate);
    auto leaf = derived(grammar, 4, 4);
    ASSERT_TRUE(leaf.fill().has_value());
    auto const darts = leaf.map().dart_count();
    ASSERT_TRUE(leaf.fill().has_value());
    EXPECT_EQ(leaf.map().dart_count(), darts);
}

TEST(Leaf, TheLimbReachesTheStalkWhereTheGrammarSaysSo)
{
    auto const grammar = grammar_of("#base\n" + kPinnate);
    auto leaf = derived(grammar, 4, 4);
    ASSERT_TRUE(leaf.fill().has_value());
    EXPECT_EQ(leaf.limb().sizes.size(), 8U);
    EXPECT_EQ(leaf.map().counts().euler_characteristic(), 1);
}

TEST(Leaf, NoLimbIsFastenedToBareFaces)
{
    auto const grammar = grammar_of("#bare : T, K\n" + kPinnate);
    auto leaf = derived(grammar, 4, 4);
    ASSERT_TRUE(leaf.fill().has_value());
    EXPECT_TRUE(leaf.limb().sizes.empty());
}

std::string label_text(EdgeLabel label)
{
    if (label == EdgeLabel::Origin)
        return "O";
    if (label == EdgeLabel::Extremity)
        return "E";
    return "C" + std::to_string(static_cast<int>(label) - static_cast<int>(side_label(1)) + 1);
}

std::string labels_of(Leaf const& leaf, FaceId face)
{
    for (Dart d = 0; d < static_cast<Dart>(leaf.map().dart_count()); d += 2)
        if (leaf.map().face(d) == face) {
            auto cycle = leaf.map().cycle(d);
            std::string text;
            // Lists the labels of a part from its edge O on. A part without that edge is listed
            // from its first dart on.
            for (std::size_t i = 0; i < cycle.size(); ++i)
                if (leaf.map().label(cycle[i]) == EdgeLabel::Origin) {
                    std::rotate(cycle.begin(), cycle.begin() + static_cast<std::ptrdiff_t>(i),
                                cycle.end());
                    break;
                }
            for (Dart const edge : cycle)
                text += label_text(leaf.map().label(edge)) + " ";
            return text;
        }
    return {};
}

TEST(Leaf, PartsOfASplitFaceKeepTheirLabels)
{
    struct Case {
        int edges;
        char const* along;
        char const* near;
        char const* far;
    };
    for (auto const& [edges, along, near, far] : {
             Case { 4, "O", "O C1 E C2 ", "O C1 E C2 " },
             Case { 4, "E", "O C1 E C2 ", "O C1 E C2 " },
             Case { 4, "C1", "O C1 E C2 ", "O C1 E C2 " },
             Case { 5, "O", "O C1 E C3 ", "O C1 C2 E C3 " },
             Case { 5, "E", "O C2 E C3 ", "O C1 C2 E C3 " },
             Case { 6, "O", "O C1 E C4 ", "O C1 C2 E C3 C4 " },
             Case { 6, "C1", "O C1 C2 C3 ", "O C1 C2 E C3 C4 " },
         }) {
        auto const grammar = grammar_of("#define A(" + std::to_string(edges)
                                        + ",1,0,0,0,1,1)\n#axiom : A\nr A -> " + along + "AA\n");
        auto const leaf = derived(grammar, 1, 1);
        EXPECT_EQ(labels_of(leaf, 0), near) << edges << along;
        EXPECT_EQ(labels_of(leaf, 1), far) << edges << along;
        EXPECT_EQ(leaf.map().counts().euler_characteristic(), 1);
    }
}

TEST(Leaf, AFaceWithoutWidthBearsOthers)
{
    auto const grammar
        = grammar_of("#define A(4,1,0,0,90,1,0)\n#define B(5,1,10,20,30,1,0)\n#axiom : A\n"
                     "a A -> A[B]E[B]C1\nb B -> B[A]E[B]C2\n");
    auto leaf = derived(grammar, 6, 6);
    ASSERT_TRUE(leaf.fill().has_value());
    EXPECT_EQ(leaf.map().fault(), "");
    for (Dart d = 0; d < static_cast<Dart>(leaf.map().dart_count()); ++d)
        EXPECT_TRUE(leaf.map().position_of(d).allFinite());
}

TEST(Leaf, RandomFacesAreThoseOfTheirSeed)
{
    auto const grammar = grammar_of("#define A(4,1,0,0,90,1,0.5)\n#axiom : A\n"
                                    "a A -> A[A(,,,,nran(0, 20),1 + ran(1),)]E\n");
    auto const end_of = [&](std::uint64_t seed) {
        auto leaf = Leaf::begin(grammar, { .final_step = 5, .seed = seed });
        for (int i = 0; i < 5; ++i)
            EXPECT_TRUE(leaf->derive().has_value());
        return leaf->map().position(static_cast<Vertex>(leaf->map().vertex_count()) - 1);
    };
    EXPECT_EQ(end_of(1), end_of(1));
    EXPECT_NE(end_of(1), end_of(2));
}

std::string failure_of(std::string const& text, int steps)
{
    auto const grammar = grammar_of(text);
    auto leaf = Leaf::begin(grammar, { .final_step = steps });
    if (!leaf)
        return leaf.error().message;
    for (int i = 0; i < steps; ++i)
        if (auto const done = leaf->derive(); !done)
            return done.error().message;
    return "derived";
}

TEST(Leaf, WhatCannotGrowIsRefusedWithItsPlace)
{
    std::string const faces = "#define A(4,1,0,0,0,1,1)\n#define P(5,1,0,0,0,1,1)\n#axiom : A\n";
    EXPECT_EQ(failure_of(faces + "r A -> A[P(4)[A]C3]E\n", 1),
              "test.leaf:4:17: at step 1 a face P of 4 edges has no such edge");
    EXPECT_EQ(failure_of(faces + "r A -> A[P(2)]E\n", 1),
              "test.leaf:4:10: at step 1 a face P has 2 edges, and may have 3 to 9999");
    EXPECT_EQ(failure_of(faces + "r A -> A[P(,,,,,1 / (step - 2))]E\nq P -> P[A]E[P]C1\n", 3),
              "derived");
    EXPECT_EQ(failure_of(faces + "#define k = 1\nr A {k = k * 1e200} {} {} -> A[A(,,,,,k)]E\n", 3),
              "test.leaf:5:32: at step 2 an attribute of a face A is not a finite number");
}

TEST(Leaf, GrowthBeyondMeasureIsRefusedSoon)
{
    std::string const faces = "#define A(9,1,0,0,0,1,1)\n#axiom : A\n";
    EXPECT_EQ(failure_of(faces + "r A -> A[A]E[A]C1[A]C2[A]C3[A]C4[A]C5\n", 50).substr(0, 11),
              "test.leaf:3");
    EXPECT_NE(failure_of(faces + "r A -> A[A(9999)]E[A(9999)]C1[A(9999)]C2\n", 50), "derived");
}

} // namespace
} // namespace tractus::leaf
