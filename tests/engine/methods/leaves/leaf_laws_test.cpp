// Tests of laws that hold for every leaf.
#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_paint.h"
#include "tests/corpus.h"
#include "tests/file_bytes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iterator>
#include <oneapi/tbb/global_control.h>
#include <string>
#include <vector>

namespace tractus::leaf {
namespace {

std::string mirrored_text(std::string text)
{
    // In the mirror image, rotations about x and z have the opposite sign, and the labels C1 and C2
    // are exchanged.
    std::string const swap[][2]
        = { { "7,30,40", "-7,30,-40" }, { "-5,10,-50", "5,10,50" }, { "3,20,90", "-3,20,-90" },
            { "]C1", "]Cx" },           { "]C2", "]C1" },           { "]Cx", "]C2" } };
    for (auto const& [from, to] : swap)
        for (auto at = text.find(from); at != std::string::npos;
             at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
    return text;
}

TEST(LeafLaws, AMirroredGrammarGrowsTheMirrorImage)
{
    std::string const text = "#define A(4,1,3,20,90,2,0.2)\n"
                             "#define R(4,0.9,7,30,40,1.5,0.1)\n"
                             "#define L(4,1.1,-5,10,-50,1.2,0.1)\n"
                             "#axiom : A\n"
                             "a A -> A[R]C1[L]C2[A]E\n"
                             "r R -> R[R]E[L]C2\n";
    auto const grown = [](std::string const& from) {
        auto const grammar = parse_grammar(from, "mirror.leaf");
        EXPECT_TRUE(grammar.has_value()) << from;
        auto leaf = Leaf::begin(*grammar, { .final_step = 4 });
        for (int i = 0; i < 4; ++i)
            EXPECT_TRUE(leaf->derive().has_value());
        std::vector<Vec3> places;
        for (Vertex v = 0; v < static_cast<Vertex>(leaf->map().vertex_count()); ++v)
            places.push_back(leaf->map().position(v));
        return places;
    };
    auto const one = grown(text);
    auto const other = grown(mirrored_text(text));
    ASSERT_EQ(one.size(), other.size());
    ASSERT_GT(one.size(), 50u);
    // The corners of a face are counterclockwise in both leaves, so they come in another order.
    // Each vertex is compared with the nearest one.
    for (auto const& place : one) {
        Vec3 const wanted(place.x(), -place.y(), place.z());
        double nearest = 1;
        for (auto const& candidate : other)
            nearest = std::min(nearest, (candidate - wanted).norm());
        EXPECT_LT(nearest, 1e-12);
    }
}

TEST(LeafLaws, PicturesAreTheSameOnAnyNumberOfThreads)
{
    auto const grammar = parse_grammar(file_bytes(shipped("leaves") / "feather.leaf"), "feather");
    ASSERT_TRUE(grammar.has_value());
    auto leaf = Leaf::begin(*grammar, { .final_step = 6 });
    while (leaf->step() < 6)
        ASSERT_TRUE(leaf->derive().has_value());
    ASSERT_TRUE(leaf->fill().has_value());
    auto const triangles = triangles_of(*leaf);
    auto const painted = [&](std::size_t threads) {
        tbb::global_control const limit(tbb::global_control::max_allowed_parallelism, threads);
        return paint_leaf(*leaf, triangles,
                          { .side = 200,
                            .has_underside = true,
                            .age = 0.5,
                            .spots = 0.3,
                            .larvae = { .count = 3 } });
    };
    auto const one = painted(1);
    for (std::size_t const threads : { 2u, 8u }) {
        auto const other = painted(threads);
        EXPECT_EQ(one.color, other.color);
        EXPECT_EQ(one.normal, other.normal);
        EXPECT_EQ(one.roughness, other.roughness);
        EXPECT_EQ(one.under_color, other.under_color);
        EXPECT_EQ(one.under_normal, other.under_normal);
    }
}

} // namespace
} // namespace tractus::leaf
