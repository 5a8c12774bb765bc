#include "engine/methods/leaves/leaf_triangles.h"
#include "tests/corpus.h"
#include "tests/file_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <string>
#include <utility>

namespace tractus::leaf {
namespace {

Grammar load(std::string const& name)
{
    auto const path = shipped("leaves") / (name + ".leaf");
    auto grammar = parse_grammar(file_bytes(path), name);
    EXPECT_TRUE(grammar.has_value()) << name;
    return *std::move(grammar);
}

Leaf filled(Grammar const& grammar, int steps)
{
    auto leaf = Leaf::begin(grammar, { .final_step = steps });
    for (int i = 0; i < steps; ++i)
        EXPECT_TRUE(leaf->derive().has_value());
    EXPECT_TRUE(leaf->fill().has_value());
    return *std::move(leaf);
}

constexpr char const* kGrammars[] = { "feather", "hand", "leaflets", "odd" };

TEST(LeafTriangles, AreTwoLessThanAFacesEdges)
{
    for (auto const* const name : kGrammars)
        for (int steps = 0; steps < 8; ++steps) {
            auto const grammar = load(name);
            auto const leaf = filled(grammar, steps);
            auto const triangles = triangles_of(leaf);
            auto const counts = leaf.map().counts();
            EXPECT_EQ(triangles.veins.size() + triangles.limb.size(), counts.triangles);
            EXPECT_EQ(triangles.positions.size(), counts.vertices);
            EXPECT_EQ(triangles.flat.size(), counts.vertices);
        }
}

// Each side of a triangle must either belong to another triangle, in the opposite direction, or lie
// on the border of the leaf.
TEST(LeafTriangles, LeaveNoGaps)
{
    for (auto const* const name : kGrammars) {
        auto const grammar = load(name);
        auto const leaf = filled(grammar, 7);
        auto const triangles = triangles_of(leaf);
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
        for (auto const* const part : { &triangles.veins, &triangles.limb })
            for (auto const& [a, b, c] : *part) {
                ++sides[{ a, b }];
                ++sides[{ b, c }];
                ++sides[{ c, a }];
            }
        // If a leaf overlaps itself, two faces may be split between the same two corners, so sides
        // are counted.
        std::size_t on_border = 0;
        for (auto const& [side, count] : sides) {
            auto const back = sides.find({ side.second, side.first });
            int const others = back == sides.end() ? 0 : back->second;
            EXPECT_LE(std::abs(count - others), 1) << name;
            on_border += count > others;
        }
        EXPECT_EQ(on_border, leaf.map().counts().border_edges) << name;
    }
}

TEST(LeafTriangles, FaceUpInTheFlatLeaf)
{
    for (auto const* const name : { "feather", "hand" }) {
        auto const grammar = load(name);
        auto const triangles = triangles_of(filled(grammar, 7));
        EXPECT_EQ(triangles.overlapping_faces, 0U);
        for (auto const& [a, b, c] : triangles.limb) {
            Vec2 const ab = triangles.flat[b] - triangles.flat[a];
            Vec2 const ac = triangles.flat[c] - triangles.flat[a];
            EXPECT_GE(ab.x() * ac.y() - ab.y() * ac.x(), -1e-12) << name;
        }
    }
}

// A leaf without bend and twist must be equal to the flat leaf. Leaves with bend or twist must keep
// their lengths in the flat leaf.
TEST(LeafTriangles, TheFlatLeafIsTheOneThatDoesNotBend)
{
    std::string const bent = "#define A(4,1,5,30,90,2,0.4)\n#define B(4,1,-10,20,40,1,0.2)\n"
                             "#axiom : A\na A -> A[B]C1[A]E\nb B -> B[B]E\n";
    std::string const flat = "#define A(4,1,0,0,90,2,0.4)\n#define B(4,1,0,0,40,1,0.2)\n"
                             "#axiom : A\na A -> A[B]C1[A]E\nb B -> B[B]E\n";
    auto const bent_grammar = parse_grammar(bent, "bent").value();
    auto const flat_grammar = parse_grammar(flat, "flat").value();
    auto const bent_leaf = triangles_of(filled(bent_grammar, 4));
    auto const flat_leaf = triangles_of(filled(flat_grammar, 4));
    ASSERT_EQ(bent_leaf.flat.size(), flat_leaf.flat.size());
    double most_bent = 0;
    for (std::size_t i = 0; i < flat_leaf.flat.size(); ++i) {
        EXPECT_LT((bent_leaf.flat[i] - flat_leaf.flat[i]).norm(), 1e-12);
        EXPECT_LT((flat_leaf.positions[i].head<2>() - flat_leaf.flat[i]).norm(), 1e-12);
        EXPECT_EQ(flat_leaf.positions[i].z(), 0);
        most_bent = std::max(most_bent, std::abs(bent_leaf.positions[i].z()));
    }
    EXPECT_GT(most_bent, 1);
}

} // namespace
} // namespace tractus::leaf
