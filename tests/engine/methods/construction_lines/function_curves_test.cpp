#include "engine/methods/construction_lines/function_curves.h"

#include "engine/lsystem/view/function_file.h"
#include "tests/engine/methods/construction_lines/sketches.h"

namespace tractus::lines {
namespace {

// Returns the functions of a construction as the tables that a model uses.
std::vector<lsystem::FunctionTable> tabulated(Construction const& construction)
{
    std::vector<lsystem::FunctionTable> tables;
    for (auto const& curve : function_curves(construction)) {
        auto const read = lsystem::parse_functions(curve.name, function_file(curve));
        EXPECT_TRUE(read) << read.error().message;
        tables.push_back(read->front());
    }
    return tables;
}

TEST(FunctionCurves, TablesHaveTheNodesValuesExactly)
{
    for (auto const& sketch : { hand_sketch(), bent_sketch(), coarse_sketch() }) {
        auto const construction = measured(sketch);
        auto const tables = tabulated(construction);
        ASSERT_EQ(tables.size(), 7U);
        for (auto const& node : construction.nodes) {
            EXPECT_NEAR(tables[0].at(node.x), construction.stem.heading_deg(node.x), 1e-5);
            EXPECT_NEAR(tables[1].at(node.x), construction.stem.pitch_deg(node.x), 1e-5);
            EXPECT_NEAR(tables[2].at(node.x), node.left_deg, 1e-5);
            EXPECT_NEAR(tables[3].at(node.x), node.right_deg, 1e-5);
            EXPECT_NEAR(tables[4].at(node.x), node.left_size, 1e-6);
            EXPECT_NEAR(tables[5].at(node.x), node.right_size, 1e-6);
        }
    }
}

// The chain of nodes in the paper begins at the stem's base. The position of each next node is that
// of the previous one plus the internode at the previous one.
TEST(FunctionCurves, InternodesLeadFromNodeToNode)
{
    auto sketch = hand_sketch();
    sketch.inclinations.push_back({ Vec2(-60, 100), Vec2(40, 100) });
    sketch.nodes_per_layer = { 4, 2 };
    auto const construction = measured(sketch);
    auto const internode = tabulated(construction)[6];
    double x = 0;
    for (auto const& node : construction.nodes) {
        x += internode.at(x);
        EXPECT_NEAR(x, node.x, 1e-4);
    }
    EXPECT_NEAR(x + internode.at(x), 1, 1e-4);
}

TEST(FunctionCurves, FilesAreWhatCpfgTakes)
{
    auto sketch = hand_sketch();
    sketch.nodes_per_layer = { 0 };
    // The line is at the very top of the stem.
    sketch.inclinations[1] = { Vec2(-60, 200), Vec2(40, 200) };
    for (auto const& curve : function_curves(measured(sketch))) {
        EXPECT_GE(curve.points.size(), 4U) << curve.name;
        EXPECT_EQ(curve.points.front().x(), 0) << curve.name;
        EXPECT_EQ(curve.points.back().x(), 1) << curve.name;
        for (std::size_t i = 1; i < curve.points.size(); ++i)
            EXPECT_GT(curve.points[i].x(), curve.points[i - 1].x()) << curve.name;
    }
    EXPECT_EQ(function_file({ "flat", { Vec2(0, -0.0), Vec2(1, 2.5) } }),
              "fver 1 1\nname: flat\nsamples: 4001\nflip: off\npoints: 2\n"
              "0.000000 0.000000 3\n1.000000 2.500000 3\n");
}

} // namespace
} // namespace tractus::lines
