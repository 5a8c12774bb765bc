#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_outline.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace tractus::leaf {
namespace {

// Returns half of a square that stands on one of its corners, with a height and width of 1.
HalfOutline diamond()
{
    return { .points = { { .is_corner = true },
                         { .at = { 0.5, 0.5 }, .is_corner = true },
                         { .at = { 0, 1 }, .is_corner = true } } };
}

Outline exact(HalfOutline const& half)
{
    Random random({});
    return { half, { .width = 0, .point = 0 }, random };
}

double area(std::vector<Vec2> const& line)
{
    double sum = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        auto const& a = line[i];
        auto const& b = line[(i + 1) % line.size()];
        sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    return sum;
}

TEST(LeafOutline, IsReachedAsFarAsItLies)
{
    auto const outline = exact(diamond());
    EXPECT_NEAR(outline.reach({ 0, 0.5 }, { 1, 0 }), 0.5, 1e-12);
    EXPECT_NEAR(outline.reach({ 0, 0 }, { 0, 1 }), 1, 1e-12);
    EXPECT_NEAR(outline.reach({ 0, 0.5 }, Vec2(1, 1).normalized()), std::sqrt(0.125), 1e-12);
    EXPECT_NEAR(outline.reach({ -0.1, 0.5 }, { -1, 0 }), 0.4, 1e-12);
    EXPECT_EQ(outline.reach({ 2, 0.5 }, { 1, 0 }), 0) << "nothing lies out there";
}

TEST(LeafOutline, RunsCounterClockwiseRoundItsArea)
{
    EXPECT_NEAR(area(exact(diamond()).line()), 0.5, 1e-12);
}

TEST(LeafOutline, IsFollowedFromOnePlaceToAnother)
{
    auto const outline = exact(diamond());
    auto const way = outline.between({ 0.25, 0.25 }, { 0.25, 0.75 }, 0.01);
    ASSERT_FALSE(way.empty());
    EXPECT_TRUE(std::ranges::any_of(
        way, [](Vec2 const& at) { return (at - Vec2(0.5, 0.5)).norm() < 1e-12; }));
    for (auto const& at : way) {
        EXPECT_GT(at.y(), 0.25);
        EXPECT_LT(at.y(), 0.75);
        EXPECT_NEAR(at.x(), std::min(at.y(), 1 - at.y()), 1e-12);
    }
    EXPECT_TRUE(outline.between({ 0.1, 0.5 }, { 0.25, 0.75 }, 0.01).empty()) << "from inside";
}

TEST(LeafOutline, HasTeethThatAddTheirArea)
{
    auto half = diamond();
    half.margin = HalfOutline::Margin::Teeth;
    half.count = 50;
    half.depth = 0.01;
    double const wider = area(exact(half).line()) - 0.5;
    // The teeth add half of their depth times the length of the margin. The part in which they fade
    // at both ends, an eighth and a sixth of the margin, counts by half.
    double const length = 2 * std::sqrt(2.0);
    EXPECT_NEAR(wider, 0.5 * 0.01 * length * (1 - 0.5 / 8 - 0.5 / 6), 0.001);
}

TEST(LeafOutline, VariesEachLeafButNotItsEnds)
{
    Random random({ .seed = 3 });
    Outline const one(diamond(), {}, random);
    Outline const other(diamond(), {}, random);
    EXPECT_GT((one.line()[10] - other.line()[10]).norm(), 1e-4);
    EXPECT_EQ(one.line()[0], Vec2(0, 0));
    EXPECT_EQ(one.line()[20], Vec2(0, 1));
}

constexpr char const* kText = R"(#define S(4,1,0,0,90,0.3,0.01)
#define M(4,1,0,0,0,1,0.01)
#define K(4,1,0,0,0,0.01,0.01)
#define R(4,1,0,0,40,1,0.002)
#define L(4,1,0,0,-40,1,0.002)
#outline : (0.5,0.5,1) (0,1,1)
#axiom : S
#base
#bare : S
#reach : M, R, L
start S -> S[M(,,,,,0.4,)]E
shoot M {} { step == 2 } {} -> M[K[R]C1[L]C2[M]E]E
)";

Leaf grown(Grammar const& grammar, double variation)
{
    auto leaf = Leaf::begin(grammar, { .final_step = 2, .variation = variation });
    for (int i = 0; i < 2; ++i)
        EXPECT_TRUE(leaf->derive().has_value());
    EXPECT_TRUE(leaf->fill().has_value());
    return *std::move(leaf);
}

TEST(LeafOutline, IsWhereVeinsEndAndTheLimbDoes)
{
    auto const grammar = parse_grammar(kText, "diamond.leaf");
    ASSERT_TRUE(grammar.has_value()) << grammar.error().message;
    auto const leaf = grown(*grammar, 0);
    auto const& map = leaf.map();
    EXPECT_EQ(map.fault(), "");
    EXPECT_EQ(map.counts().euler_characteristic(), 1);
    EXPECT_EQ(map.counts().border_cycles, 1u);
    Vec2 const base(0, 0.3);
    std::vector<Vec2> border;
    for (auto const d : map.border(0)) {
        Vec2 const at = map.flat_of(d) - base;
        border.push_back(at);
        if (at.y() > 0.02) {
            EXPECT_NEAR(std::abs(at.x()), std::min(at.y(), 1 - at.y()), 0.006);
        }
    }
    // Area of the blade, half a square, and of the petiole, 0.3 long and 0.01 wide.
    EXPECT_NEAR(std::abs(area(border)), 0.5 + 0.003, 0.003);
}

TEST(LeafOutline, KeepsLeavesWholeWhereTheyVary)
{
    auto const grammar = parse_grammar(kText, "diamond.leaf");
    auto const leaf = grown(*grammar, 3);
    EXPECT_EQ(leaf.map().fault(), "");
    EXPECT_EQ(leaf.map().counts().euler_characteristic(), 1);
}

// The angle between the directions of the first and the last main vein must be the whole bend.
TEST(LeafPose, BendsByItsAngleAndLeavesTheFlatLeaf)
{
    auto const grammar = parse_grammar(kText, "diamond.leaf");
    auto const posed = [&](Leaf::Pose const& pose) {
        auto leaf = Leaf::begin(*grammar, { .final_step = 2, .variation = 0, .pose = pose });
        for (int i = 0; i < 2; ++i)
            EXPECT_TRUE(leaf->derive().has_value());
        EXPECT_TRUE(leaf->fill().has_value());
        return *std::move(leaf);
    };
    auto const straight = posed({});
    auto const bent = posed({ .bend_deg = 80, .curl_deg = 30, .twist_deg = 20, .uneven_deg = 5 });
    ASSERT_EQ(straight.map().vertex_count(), bent.map().vertex_count());
    double highest = 0;
    for (Vertex v = 0; v < static_cast<Vertex>(bent.map().vertex_count()); ++v) {
        EXPECT_EQ(bent.map().flat(v), straight.map().flat(v));
        EXPECT_EQ(straight.map().position(v).z(), 0);
        highest = std::max(highest, std::abs(bent.map().position(v).z()));
    }
    EXPECT_GT(highest, 0.1);
    auto const only_bent = posed({ .bend_deg = 80 });
    Vec3 tip = Vec3::Zero();
    Vec3 before = Vec3::Zero();
    for (Vertex v = 0; v < static_cast<Vertex>(only_bent.map().vertex_count()); ++v) {
        auto const& flat = only_bent.map().flat(v);
        if (std::abs(flat.x()) < 0.006 && flat.y() > 1.28)
            tip = only_bent.map().position(v);
        if (std::abs(flat.x()) < 0.006 && std::abs(flat.y() - 0.71) < 1e-9)
            before = only_bent.map().position(v);
    }
    double const down = std::atan2(before.z() - tip.z(), tip.y() - before.y()) / radians(1);
    EXPECT_NEAR(down, 80, 0.5);
}

TEST(LeafOutline, IsRefusedWithItsPlace)
{
    struct Case {
        std::string text;
        std::string message;
    };
    for (auto const& [text, message] :
         { Case { "#outline : (0.5,0.5)", "my.leaf:1:10: an outline has two points" },
           Case { "#outline : (0.5,0.5) (0.2,1)", "whose x is 0" },
           Case { "#left : (0.2,0.5) (0,1)", "my.leaf:1:7: #left ends at the tip" },
           Case { "#outline : (0.5) (0,1)", "my.leaf:1:12: a point is (x,y)" },
           Case { "#young(1,2,300)", "my.leaf:1:7: a colour is (red,green,blue)" },
           Case { "#steps(0)", "my.leaf:1:7: #steps has one number above 0" },
           Case { "#margin : teeth(,1)", "a margin has a number" } }) {
        auto const grammar
            = parse_grammar(text + "\n#define A(4,1,0,0,0,1,1)\n#axiom : A\n", "my.leaf");
        ASSERT_FALSE(grammar.has_value()) << text;
        EXPECT_NE(grammar.error().message.find(message), std::string::npos)
            << grammar.error().message;
    }
}

} // namespace
} // namespace tractus::leaf
