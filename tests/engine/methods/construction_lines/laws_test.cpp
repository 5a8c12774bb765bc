#include "tests/engine/methods/construction_lines/sketches.h"

// Tests of laws that hold for every construction-line sketch.

namespace tractus::lines {
namespace {

using Kind = Pattern::Kind;

void expect_equal(Construction const& a, Construction const& b)
{
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        EXPECT_NEAR(a.nodes[i].x, b.nodes[i].x, 1e-9);
        EXPECT_NEAR(a.nodes[i].left_deg, b.nodes[i].left_deg, 1e-6);
        EXPECT_NEAR(a.nodes[i].right_deg, b.nodes[i].right_deg, 1e-6);
        EXPECT_NEAR(a.nodes[i].left_size, b.nodes[i].left_size, 1e-9);
        EXPECT_NEAR(a.nodes[i].right_size, b.nodes[i].right_size, 1e-9);
    }
}

TEST(ConstructionLaws, AMirroredSketchGivesTheMirroredPlant)
{
    for (auto const kind : { Kind::Distichous, Kind::Decussate, Kind::Whorled })
        for (auto const& sketch : { hand_sketch(), bent_sketch(), coarse_sketch() }) {
            Pattern const pattern { .kind = kind, .whorl = 4 };
            auto tips = tips_of(sketch, pattern);
            auto others = tips_of(mirrored(sketch), pattern);
            ASSERT_EQ(tips.size(), others.size());
            for (auto& other : others)
                other.x() = -other.x();
            // The organs of a node come in another order, so each is compared with the nearest one.
            auto const nearest_mm = [&](Vec3 const& tip) {
                double least = std::numeric_limits<double>::infinity();
                for (auto const& other : others)
                    least = std::min(least, (other - tip).norm());
                return least;
            };
            for (auto const& tip : tips)
                EXPECT_LT(nearest_mm(tip), 2e-3);
        }
}

TEST(ConstructionLaws, AMirroredSketchExchangesTheFunctions)
{
    auto const result = measured(bent_sketch());
    auto other = measured(mirrored(bent_sketch()));
    for (int i = 0; i <= 20; ++i)
        EXPECT_DOUBLE_EQ(values_at(result, i / 20.0).heading_deg,
                         -values_at(other, i / 20.0).heading_deg);
    for (auto& node : other.nodes) {
        std::swap(node.left_deg, node.right_deg);
        std::swap(node.left_size, node.right_size);
    }
    expect_equal(result, other);
}

TEST(ConstructionLaws, LinesMayBeDrawnTheOtherWayAndInAnyOrder)
{
    auto sketch = bent_sketch();
    auto const result = measured(sketch);
    std::reverse(sketch.left.begin(), sketch.left.end());
    std::reverse(sketch.right.begin(), sketch.right.end());
    for (auto& line : sketch.inclinations)
        std::reverse(line.begin(), line.end());
    std::swap(sketch.inclinations[0], sketch.inclinations[1]);
    expect_equal(result, measured(sketch));
}

TEST(ConstructionLaws, AScaledAndMovedSketchIsTheSame)
{
    auto sketch = bent_sketch();
    auto const result = measured(sketch);
    auto const move = [](Vec2& point) { point = 3 * point + Vec2(7, -2); };
    for (auto& point : sketch.stem)
        point = 3 * point + Vec3(7, -2, 0);
    std::for_each(sketch.left.begin(), sketch.left.end(), move);
    std::for_each(sketch.right.begin(), sketch.right.end(), move);
    for (auto& line : sketch.inclinations)
        std::for_each(line.begin(), line.end(), move);
    expect_equal(result, measured(sketch));
}

// Expects the tips of organs on the boundaries, for models with few and many nodes, whose plants
// are made from their text.
void expect_tips_on_boundaries(LineSketch sketch, double tolerance, int most_nodes = 500)
{
    for (int const nodes : { 1, 3, 20, 60, 150, most_nodes }) {
        sketch.nodes_per_layer.assign(sketch.nodes_per_layer.size(), nodes);
        auto const length_mm = measured(sketch).stem.length_mm();
        auto const tips = tips_of(sketch, { .kind = Kind::Distichous });
        auto const layers = static_cast<int>(sketch.nodes_per_layer.size());
        ASSERT_EQ(static_cast<int>(tips.size()), 2 * (nodes * layers + 1));
        for (std::size_t i = 0; i < tips.size(); ++i)
            EXPECT_LT(distance_mm(tips[i], i % 2 == 0 ? sketch.left : sketch.right),
                      tolerance * length_mm)
                << nodes << " nodes, organ " << i;
    }
}

TEST(ConstructionLaws, OrganTipsLieOnTheBoundaryOfAStraightStem)
{
    expect_tips_on_boundaries(hand_sketch(), 1e-3);
    // The angles of organs change by 45 degrees within a tenth of the stem.
    auto steep = hand_sketch();
    steep.inclinations[1] = { Vec2(-60, 60), Vec2(0, 60), Vec2(40, 60) };
    steep.nodes_per_layer = { 4 };
    expect_tips_on_boundaries(steep, 1e-3);
}

TEST(ConstructionLaws, OrganTipsLieOnTheBoundaryOfACurvedStem)
{
    expect_tips_on_boundaries(bent_sketch(), 3e-3);
    // Near a sharp corner, the function tables of a model are too coarse for 500 nodes.
    expect_tips_on_boundaries(coarse_sketch(), 3e-3, 150);
}

TEST(ConstructionLaws, TipsOfEvenDecussateNodesLieOnTheBoundary)
{
    auto const sketch = bent_sketch();
    auto const length_mm = measured(sketch).stem.length_mm();
    auto const tips = tips_of(sketch, { .kind = Kind::Decussate });
    for (std::size_t i = 0; i < tips.size(); i += 4) {
        EXPECT_LT(distance_mm(tips[i], sketch.left), 3e-3 * length_mm);
        EXPECT_LT(distance_mm(tips[i + 1], sketch.right), 3e-3 * length_mm);
    }
}

// The stem comes towards the viewer and goes back. Seen from the front, organs must end on their
// boundaries.
TEST(ConstructionLaws, OrganTipsOfADeepStemAreSeenOnTheBoundary)
{
    LineSketch sketch { .stem = { Vec3::Zero() },
                        .left = { Vec2(-50, 0), Vec2(-50, 300) },
                        .right = { Vec2(50, 0), Vec2(50, 300) },
                        .inclinations = { { Vec2(-60, 70), Vec2(0, 30), Vec2(60, 70) },
                                          { Vec2(-60, 155), Vec2(0, 130), Vec2(60, 155) } },
                        .nodes_per_layer = { 8 } };
    for (int i = 0; i < 400; ++i) {
        double const pitch = radians(60 * std::sin(2 * kPi * (i + 0.5) / 400));
        sketch.stem.push_back(sketch.stem.back() + 0.5 * Vec3(0, std::cos(pitch), std::sin(pitch)));
    }
    EXPECT_NEAR(measured(sketch).stem.length_mm(), 200, 1e-9);
    for (auto const& tip : tips_of(sketch, { .kind = Kind::Distichous }))
        EXPECT_NEAR(std::fabs(tip.x()), 50, 3e-3 * 200);
}

} // namespace
} // namespace tractus::lines
