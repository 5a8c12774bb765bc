#include "engine/plant/measured_plant.h"
#include "engine/plant/mtg.h"
#include "engine/plant/ply_skeleton.h"
#include "engine/plant/qsm.h"
#include "engine/plant/skeleton_lines.h"

#include <cstring>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

namespace tractus {
namespace {

void expect_near(Vec3 const& found, Vec3 const& expected)
{
    EXPECT_LT((found - expected).norm(), 1e-9) << found << "\nin place of\n" << expected;
}

TEST(MeasuredPlant, PutsAxesTogether)
{
    std::vector<MeasuredNode> const nodes {
        { .position_mm = { 5, 0, 1 }, .radius_mm = 3 },
        { .below = 0, .continues = true, .position_mm = { 5, 0, 11 }, .radius_mm = 2 },
        { .below = 1, .position_mm = { 9, 0, 11 }, .radius_mm = 1 },
        { .below = 1, .continues = true, .position_mm = { 5, 0, 21 } },
        { .below = 0, .position_mm = { 5, 4, 1 }, .radius_mm = 1, .base_radius_mm = 1.5 },
    };
    auto const plant = plant_from_nodes("tree", nodes);
    ASSERT_TRUE(plant) << plant.error().message;
    check_plant(*plant);
    ASSERT_EQ(plant->axes.size(), 3u);
    EXPECT_EQ(plant->axes[0].segment_count, 2u);
    EXPECT_EQ(plant->axes[1].parent_segment,
              kNone); // The branch begins at the base of the trunk, where no segment ends.
    EXPECT_EQ(plant->axes[2].parent_segment, 0u);
    EXPECT_EQ(plant->axes[2].order, 1u);
    expect_near(plant->node_position_mm[0], { 0, 0, 0 });
    expect_near(plant->node_position_mm[2], { 0, 0, 20 });
    EXPECT_EQ(plant->node_radius_mm, (std::vector<float> { 3, 2, 2, 1.5, 1, 1, 1 }));
}

TEST(MeasuredPlant, RefusesWhatIsNoPlant)
{
    std::vector<MeasuredNode> nodes { {} };
    EXPECT_EQ(plant_from_nodes("tree", nodes).error().message,
              "tree: there is no branch in it: two positions, one above the other, make one");
    nodes.push_back({ .below = 0, .continues = true, .position_mm = { 0, 0, 1 }, .radius_mm = -1 });
    EXPECT_EQ(plant_from_nodes("tree", nodes).error().message,
              "tree: the position or the diameter of node 2 is no length: export the plant again");
}

TEST(MeasuredPlant, RefusesWhatIsTooLargeTooFarAwayOrOnePoint)
{
    auto const error = [](Vec3 const& from, Vec3 const& to) {
        std::vector<MeasuredNode> const nodes {
            { .position_mm = from, .radius_mm = 1 },
            { .below = 0, .continues = true, .position_mm = to, .radius_mm = 1 }
        };
        auto const plant = plant_from_nodes("tree", nodes);
        return plant ? "no error" : plant.error().message;
    };
    EXPECT_EQ(error({ 0, 0, 0 }, { 0, 0, 1e7 }), "no error");
    EXPECT_EQ(error({ 0, 0, 0 }, { 0, 0, 3e300 }),
              "tree: this plant is 3e+297 m large, expected at most 10 km: are its lengths metres "
              "or millimetres?");
    EXPECT_EQ(error({ -2e12, 0, 0 }, { -2e12, 0, 9 }),
              "tree: this plant is more than a million km away from the origin of its file: move "
              "it nearer");
    EXPECT_EQ(error({ 5, 5, 5 }, { 5, 5, 5 }),
              "tree: there is no branch in it: two positions, one above the other, make one");
    std::vector<SkeletonPiece> const lines { { { 0, 0, 0 }, { 0, 0, 3e300 } } };
    EXPECT_FALSE(plant_from_lines("tree", lines));
}

TEST(Qsm, ReadsTreeQsmsColumns)
{
    auto const plant = parse_qsm("tree.txt",
                                 // Columns are separated by tabs, so blanks may be inside a column.
                                 "0.1\t1\t0 0 0\n");
    EXPECT_FALSE(plant);
    auto const tree = parse_qsm("tree.txt",
                                "radius (m)\tlength (m)\tstart_point\taxis_direction\tparent\n"
                                "0.2\t1\t10\t20\t5\t0\t0\t1\t0\t2\t1\t0\t1\n"
                                "0.1\t2\t10\t20\t6\t0\t0\t1\t1\t0\t1\t0\t2\n"
                                "0.05\t1\t10.2\t20\t6\t1\t0\t0\t1\t0\t2\t1\t1\n");
    ASSERT_TRUE(tree) << tree.error().message;
    check_plant(*tree);
    ASSERT_EQ(tree->axes.size(), 2u);
    EXPECT_EQ(tree->axes[0].segment_count, 2u);
    EXPECT_EQ(tree->axes[1].parent_segment, 0u);
    expect_near(tree->node_position_mm[2], { 0, 0, 3000 });
    expect_near(tree->node_position_mm[4],
                { 1200, 0, 1000 }); // The branch begins at the end of the stem's cylinder.
    EXPECT_EQ(tree->node_radius_mm[0], 200);
    EXPECT_EQ(tree->node_radius_mm[3], 50);
}

// TreeQSM 2.3 writes no names of columns. After the column "extension" it has these columns: added,
// unmodified radius, branch, order and position. Each branch begins with an added cylinder.
TEST(Qsm, FollowsExtensionsWhateverColumnsComeBehindThem)
{
    auto const tree = parse_qsm("tree.txt",
                                "0.2\t1\t4\t9\t1\t0\t0\t1\t0\t2\t0\t0.2\t1\t0\t1\n"
                                "0.1\t1\t4\t9\t2\t0\t0\t1\t1\t0\t0\t0.1\t1\t0\t2\n"
                                "0.05\t1\t4\t9\t2\t1\t0\t0\t1\t4\t1\t0.05\t2\t1\t1\n"
                                "0.04\t1\t5\t9\t2\t1\t0\t0\t3\t0\t0\t0.04\t2\t1\t2\n");
    ASSERT_TRUE(tree) << tree.error().message;
    ASSERT_EQ(tree->axes.size(), 2u);
    EXPECT_EQ(tree->axes[0].segment_count, 2u);
    EXPECT_EQ(tree->axes[1].segment_count, 2u);
    expect_near(tree->node_position_mm.back(), { 2000, 0, 1000 });
}

TEST(Qsm, ReadsNamedColumnsInAnyOrder)
{
    auto const tree = parse_qsm("tree.csv",
                                "\"ID\",parentID,startX,startY,startZ,endX,endY,endZ,radius\n"
                                "7,3,0,0,1,0,0,2,0.02\n"
                                "3,-1,0,0,0,0,0,1,0.05\n"
                                "9,3,0,0,1,1,0,1,0.03\n");
    ASSERT_TRUE(tree) << tree.error().message;
    ASSERT_EQ(tree->axes.size(), 2u);
    // The thicker of the two cylinders continues the axis.
    expect_near(tree->node_position_mm[2], { 1000, 0, 1000 });
}

TEST(Qsm, SaysWhatIsWrong)
{
    auto const error = [](std::string const& text) {
        auto const tree = parse_qsm("tree.csv", text);
        return tree ? "no error" : tree.error().message;
    };
    EXPECT_EQ(error("start_x,radius\n"),
              "tree.csv:1: the columns need radius, parent, start_x, start_y, start_z, and end_x, "
              "end_y, end_z or axis_x, axis_y, axis_z and length");
    EXPECT_EQ(error("0.1,1,0,0,0,0,0,x,0,0,1\n"),
              "tree.csv:1: found x in column 8, expected a number");
    EXPECT_EQ(
        error("0.1,1,0,0\n"),
        "tree.csv:1: the line has 4 columns, expected at least 10: radius, length, start (3), "
        "axis (3), parent and extension");
    EXPECT_EQ(error("start_x,start_y,start_z,end_x,end_y,end_z,radius,parent\n0,0,0,0,0,1,2\n"),
              "tree.csv:2: the line has 7 columns, expected one for each name in the first line");
    EXPECT_EQ(error("0.1,1,0,0,0,0,0,1,2,0,1\n0.1,1,0,0,0,0,0,1,1,0,1\n"),
              "tree.csv: 2 of 2 cylinders stand on each other and not on the ground");
    EXPECT_EQ(error(""),
              "tree.csv: there is no branch in it: two positions, one above the other, make one");
}

Result<Plant> ply(std::string const& text)
{
    return parse_ply_skeleton("tree.ply", std::as_bytes(std::span(text)));
}

void append(std::string& bytes, auto value)
{
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

// Returns a binary PLY file of a tree in little-endian byte order, as on all supported machines.
std::string binary_tree()
{
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n"
                        "property float x\nproperty float y\nproperty float z\n"
                        "property float radius\nelement edge 2\n"
                        "property list uint uint vertex_indices\nend_header\n";
    for (float const value :
         { 0.F, 0.F, 1.F, 0.25F, 0.F, 0.F, 3.F, 0.125F, 2.F, 0.F, 3.F, 0.0625F })
        append(bytes, value);
    for (std::uint32_t const value : { 2u, 1u, 0u, 2u, 1u, 2u })
        append(bytes, value);
    return bytes;
}

TEST(PlySkeleton, ReadsEdgesAndRadii)
{
    auto const tree = ply(binary_tree());
    ASSERT_TRUE(tree) << tree.error().message;
    check_plant(*tree);
    ASSERT_EQ(tree->axes.size(), 1u);
    expect_near(tree->node_position_mm[1], { 0, 0, 2000 });
    expect_near(tree->node_position_mm[2], { 2000, 0, 2000 });
    EXPECT_EQ(tree->node_radius_mm, (std::vector<float> { 250, 125, 62.5 }));
}

TEST(PlySkeleton, ReadsAsciiAndComputesMissingRadii)
{
    auto const tree = ply("ply\nformat ascii 1.0\ncomment a tree\nelement vertex 2\n"
                          "property double x\nproperty double y\nproperty double z\n"
                          "element face 1\nproperty list uchar int vertex_indices\n"
                          "element edge 1\nproperty int vertex1\nproperty int vertex2\n"
                          "end_header\n0 0 0\n0 0 2\n3 0 1 0\n0 1\n");
    ASSERT_TRUE(tree) << tree.error().message;
    expect_near(tree->node_position_mm[1], { 0, 0, 2000 });
    EXPECT_GT(tree->node_radius_mm[0], 0);
}

TEST(PlySkeleton, LeavesRadiiOutThatOnlySomeVerticesHave)
{
    std::string const text = "ply\nformat ascii 1.0\n"
                             "element vertex 1\nproperty float x\nproperty float y\n"
                             "property float z\n"
                             "element vertex 2\nproperty float x\nproperty float y\n"
                             "property float z\nproperty float radius\n"
                             "element edge 2\nproperty int vertex1\nproperty int vertex2\n"
                             "end_header\n0 0 0\n0 0 1 0.1\n0 0 2 0.1\n0 1\n1 2\n";
    auto const plant = parse_ply_skeleton("some.ply", std::as_bytes(std::span(text)));
    ASSERT_TRUE(plant) << plant.error().message;
    EXPECT_EQ(plant->segment_count(), 2u);
}

TEST(PlySkeleton, SaysWhatIsWrong)
{
    auto const error = [](std::string const& text) {
        auto const tree = ply(text);
        return tree ? "no error" : tree.error().message;
    };
    EXPECT_EQ(error("obj"), "tree.ply: this is no PLY file: its first line is not \"ply\"");
    EXPECT_EQ(error("ply\nformat ascii 1.0\n"),
              "tree.ply: the header of this PLY file has no end_header");
    auto const whole = binary_tree();
    EXPECT_EQ(error(whole.substr(0, whole.size() - 1)),
              "tree.ply: the file ends before its last element");
    EXPECT_EQ(error("ply\nelement vertex 4000000000\nproperty int x\nend_header\n1 2\n"),
              "tree.ply: the file ends before its last element");
    EXPECT_EQ(error("ply\nelement vertex 1\nproperty int x\nelement edge 1\nproperty int a\n"
                    "property int b\nend_header\n1\n0 1\n"),
              "tree.ply: an edge ends at vertex 1, but there are 1");
    EXPECT_EQ(error("ply\nelement vertex 1\nproperty int x\nend_header\n1\n"),
              "tree.ply: there are no edges in it: export the skeleton, not its surface or points");
}

// A file in which bytes are changed, removed or duplicated must give a valid plant or an error.
TEST(MeasuredPlant, IsWholeWhateverComesIn)
{
    std::string const graph = "CODE: FORM-A\nCLASSES:\nSYMBOL\tSCALE\n$\t0\nP\t1\nS\t2\nMTG:\n"
                              "ENTITY-CODE\t\tXX\tYY\tZZ\tTopDia\n/P1/S1\t\t0\t0\t0\t5\n"
                              "^<S2<<S4\t\t0\t0\t9\t4\n\t+S1\t3\t0\t9\t2\n^<S5\t\t0\t1\t20\n";
    std::string const organs
        = "CODE: FORM-A\nCLASSES:\nSYMBOL\tSCALE\nP\t1\nS\t2\nL\t2\nO\t2\nMTG:\n"
          "ENTITY-CODE\t\tXX\tYY\tZZ\tLength\tWidth\tDepth\tPetiole\tDirectionX\t"
          "DirectionY\tDirectionZ\tNormalX\tNormalY\tNormalZ\tShape\n"
          "/P1/S1\t\t0\t0\t0\n\t+O1\t1\t2\t3\t4\t5\t6\t\t0\t0\t1\t1\t0\t0\tball-1\n"
          "^<S2\t\t0\t0\t9\n\t+L2\t1\t2\t3\t-4e5\t5\t\t1\t0\t0\t-1\t0\t0\t1\tblade-2\n";
    std::string const cylinders = "0.1,1,0,0,0,0,0,1,0,2,1\n0.1,1,0,0,1,0,0,1,1,0,1\n"
                                  "0.05,1,0,0,1,1,0,0,1,0,2\n";
    std::mt19937 numbers(7);
    auto const below = [&](std::size_t end) { return numbers() % end; };
    auto const expect_whole = [](Result<Plant> const& plant) {
        if (plant)
            check_plant(*plant);
        else
            EXPECT_FALSE(plant.error().message.empty());
    };
    for (int i = 0; i < 3000; ++i)
        for (auto text : { graph, organs, cylinders, binary_tree() }) {
            bool const is_graph = text.starts_with("CODE");
            bool const is_ply = text.starts_with("ply");
            for (auto changes = 1 + below(4); changes > 0; --changes) {
                auto const at = below(text.size());
                if (auto const how = below(3); how == 0)
                    text[at] = "0123456789-.,/<+^eEPS\t\n\xff"[below(24)];
                else if (how == 1)
                    text.erase(at, 1 + below(3));
                else
                    text.insert(at, text.substr(below(text.size()), 1 + below(6)));
            }
            expect_whole(is_ply         ? ply(text)
                             : is_graph ? parse_mtg("a", text)
                                        : parse_qsm("a", text));
        }
}

} // namespace
} // namespace tractus
