#include "engine/plant/mtg.h"
#include "tests/engine/plant/small_plant.h"

#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

namespace tractus {
namespace {

std::string written(Plant const& plant)
{
    std::ostringstream out;
    write_mtg(out, plant);
    return out.str();
}

constexpr char const* kHeader = "CODE :\tFORM-A\n\nCLASSES :\nSYMBOL\tSCALE\tDECOMPOSITION\n"
                                "$\t0\tFREE\nP\t1\tFREE\nB\t2\tFREE\nS\t3\tFREE\nLeaf\t3\tFREE\n\n"
                                "DESCRIPTION :\nLEFT\tRIGHT\tRELTYPE\tMAX\nS\tS\t<\t?\n\n"
                                "FEATURES :\nNAME\tTYPE\nXX\tREAL\n\nMTG :\n";

std::string with_header(std::string const& lines)
{
    return kHeader + lines;
}

std::string error(std::string const& text)
{
    auto const plant = parse_mtg("tree.mtg", text);
    return plant ? "no error" : plant.error().message;
}

TEST(Mtg, WritesTheFormatsTable)
{
    auto const text = written(small_plant());
    auto const table = text.substr(text.find("MTG:\n"));
    EXPECT_EQ(table,
              "MTG:\nENTITY-CODE\t\t\tXX\tYY\tZZ\tLength\tTopDiameter\tBottomDiameter\t"
              "Width\tDepth\tPetiole\tDirectionX\tDirectionY\tDirectionZ\tNormalX\tNormalY\t"
              "NormalZ\tShape\n"
              "/P1\n^/A1\n"
              "^/S0\t\t\t0\t0\t0\t0\t20\t20\n"
              "^<S1\t\t\t0\t0\t100\t100\t16\t20\n"
              "\t+A2\n"
              "\t^/S1\t\t50\t0\t100\t50\t4\t6\n"
              "\t^<S2\t\t100\t0\t100\t50\t2\t4\n"
              "\t\t+L1\t100\t0\t100\t50\t\t\t25\t\t\t0\t1\t0\t0\t0\t1\tblade-1\n"
              "^<S2\t\t\t0\t0\t200\t100\t12\t16\n"
              "^<S3\t\t\t0\t0\t300\t100\t8\t12\n");
}

// Returns a plant of three trunks, two of which have no branches.
Plant plant_of_three_trunks()
{
    auto plant = small_plant();
    for (double const x : { 7.0, 9.0 }) {
        plant.axes.push_back({ .first_node = static_cast<NodeId>(plant.node_position_mm.size()),
                               .first_segment = static_cast<SegmentId>(plant.segment_count()),
                               .segment_count = 1 });
        plant.node_position_mm.insert(plant.node_position_mm.end(), { { x, 0, 0 }, { x, 0, 9 } });
        plant.node_radius_mm.insert(plant.node_radius_mm.end(), { 1.25F, 0.75F });
        plant.segment_material.push_back(0);
    }
    return plant;
}

TEST(Mtg, WritesOnePlantOfAllTrunks)
{
    auto const plant = plant_of_three_trunks();
    check_plant(plant);
    auto const text = written(plant);
    EXPECT_EQ(text.find("\n/P1\n\t/A1\n\t^/S0\t\t\t0\t0\t0\t"), text.find("\n/P"));
    EXPECT_EQ(text.find("\n/P", text.find("\n/P1") + 1), std::string::npos);
    EXPECT_NE(text.find("\n\t\t+A2\n\t\t^/S1\t\t50\t"), std::string::npos) << text;
    EXPECT_NE(text.find("\n\t/A3\n\t^/S0\t\t\t7\t0\t0\t"), std::string::npos) << text;
    auto const read = parse_mtg("tree.mtg", text);
    ASSERT_TRUE(read) << read.error().message;
    check_plant(*read);
    // Axes are numbered in the order of their branching orders.
    ASSERT_EQ(read->axes.size(), 4u);
    for (AxisId i = 0; i < 3; ++i)
        EXPECT_EQ(read->axes[i].parent_segment, kNone) << i;
    EXPECT_EQ(read->axes[3].parent_segment, 0u);
    EXPECT_EQ(read->positions(read->axes[2])[0], Vec3(9, 0, 0));
    EXPECT_EQ(read->positions(read->axes[3])[1], Vec3(50, 0, 100));
    EXPECT_EQ(written(*parse_mtg("tree.mtg", written(*read))), written(*read));
}

// Reads the text like openalea.mtg: tabs open and close brackets, ^ continues from the entity
// above, and / with the same or a coarser class climbs to the complex. Returns the number of trunks
// of each entity of class P: the entities below it that have no parent.
std::vector<int> trunks_as_in_openalea(std::string const& text)
{
    std::vector<int> trunks;
    std::istringstream lines(text.substr(text.find("ENTITY-CODE")));
    std::string line;
    std::getline(lines, line);
    std::vector<std::size_t> indents { 0 };
    while (std::getline(lines, line)) {
        auto const indent = line.find_first_not_of('\t');
        auto const code = line.substr(indent, line.find('\t', indent) - indent);
        bool const goes_on = code.front() == '^';
        // openalea refuses a line that begins with ^ further to the right than the line above.
        EXPECT_FALSE(goes_on && indent > indents.back()) << line;
        while (indent < indents.back())
            indents.pop_back();
        if (indent > indents.back())
            indents.push_back(indent);
        auto const entity = code.substr(goes_on ? 1 : 0);
        if (entity.starts_with("/P"))
            trunks.push_back(0);
        // An axis that begins with + or < has a parent, so it is not a trunk.
        if (entity.starts_with("/A"))
            ++trunks.back();
    }
    return trunks;
}

TEST(Mtg, HasOnePlantForOtherReaders)
{
    EXPECT_EQ(trunks_as_in_openalea(written(small_plant())), std::vector<int> { 1 });
    EXPECT_EQ(trunks_as_in_openalea(written(plant_of_three_trunks())), std::vector<int> { 3 });
}

TEST(Mtg, ReadsWhatItWrites)
{
    auto plant = small_plant();
    // Adds a second axis on the same segment, an axis on the lateral, and an axis on the ground.
    auto const add = [&](SegmentId on, AxisId parent, std::uint32_t order, Vec3 const& from,
                         Vec3 const& to) {
        plant.axes.push_back({ .first_node = static_cast<NodeId>(plant.node_position_mm.size()),
                               .first_segment = static_cast<SegmentId>(plant.segment_count()),
                               .segment_count = 1,
                               .parent_segment = on,
                               .parent_axis = parent,
                               .order = order });
        plant.node_position_mm.insert(plant.node_position_mm.end(), { from, to });
        plant.node_radius_mm.insert(plant.node_radius_mm.end(), { 1.25F, 0.75F });
        plant.segment_material.push_back(0);
    };
    add(0, 0, 1, { 0, 0, 100 }, { -30.1, 1e-7, 100 });
    add(3, 1, 2, { 50, 0, 100 }, { 50, 1234.5678901234567, 100 });
    add(kNone, kNone, 0, { 7, 7, 0 }, { 7, 7, 9 });
    check_plant(plant);
    auto const read = parse_mtg("tree.mtg", written(plant));
    ASSERT_TRUE(read) << read.error().message;
    check_plant(*read);
    // Reading numbers the axes in the order of the file, which may differ from the order in the
    // plant.
    EXPECT_EQ(written(*parse_mtg("tree.mtg", written(*read))), written(*read));
    ASSERT_EQ(read->axes.size(), plant.axes.size());
    ASSERT_EQ(read->segment_count(), plant.segment_count());
    auto const lines = [](Plant const& of) { // Returns the lines of the segments in sorted order.
        std::vector<std::array<double, 8>> result;
        for (SegmentId i = 0; i < of.segment_count(); ++i) {
            auto const [base, tip] = nodes_of(of, i);
            auto const& from = of.node_position_mm[base];
            auto const& to = of.node_position_mm[tip];
            result.push_back({ from.x(), from.y(), from.z(), to.x(), to.y(), to.z(),
                               static_cast<double>(of.node_radius_mm[base]),
                               static_cast<double>(of.node_radius_mm[tip]) });
        }
        std::sort(result.begin(), result.end());
        return result;
    };
    EXPECT_EQ(lines(*read), lines(plant)); // The numbers must be equal to the last digit.
}

// In fieldwork there are several conventions: a branch may be named in the column of its parent or
// one further to the right, intermediate entities may be omitted, and entities may lack a position.
TEST(Mtg, ReadsBothWaysToNameBranches)
{
    auto const below = parse_mtg("tree.mtg",
                                 with_header("ENTITY-CODE\t\t\t\tXX\tYY\tZZ\n"
                                             "/P1\n"
                                             "\t/B1\n"
                                             "\t\t/S1\t\t0\t0\t0\n"
                                             "\t\t^<S2\t\t0\t0\t200\n"
                                             "\t\t^+B2\n"
                                             "\t\t\t/S1\t50\t0\t250\n"
                                             "\t\t\t^<S2\t90\t0\t250\n"
                                             "\t\t^+B3\n"
                                             "\t\t\t/S1\t-50\t0\t250\n"
                                             "\t\t^<S3\t\t0\t0\t400 # the tip\n"));
    ASSERT_TRUE(below) << below.error().message;
    check_plant(*below);
    ASSERT_EQ(below->axes.size(), 3u);
    EXPECT_EQ(below->axes[0].segment_count, 2u);
    EXPECT_EQ(below->axes[1].parent_segment, 0u);
    EXPECT_EQ(below->axes[1].segment_count, 2u);
    EXPECT_EQ(below->axes[2].parent_segment, 0u);
    auto const beside = parse_mtg("tree.mtg",
                                  with_header("TOPO\t\tXX\tYY\tZZ\tdiam\n"
                                              "/P1/B1/S1\t\t0\t0\t0\t40\n"
                                              "^<S2<<S4\t\t0\t0\t2\t30\n"
                                              "\t+B2/S1\t1\t0\t2\t10\n"
                                              "\t^<Leaf1\t2\t0\t2\t99\n"
                                              "^<S5\t\t0\t0\t3\t20\n"));
    ASSERT_TRUE(beside) << beside.error().message;
    ASSERT_EQ(beside->axes.size(), 2u);
    EXPECT_EQ(beside->axes[0].segment_count, 2u);
    // The numbers are so small that they must be in metres.
    EXPECT_EQ(beside->node_position_mm[2], Vec3(0, 0, 3000));
    EXPECT_EQ(beside->node_radius_mm[0], 20'000);
}

TEST(Mtg, ReadsRadiiInPlaceOfDiameters)
{
    auto const plant = parse_mtg("tree.mtg",
                                 with_header("ENTITY-CODE\tXX\tYY\tZZ\tradius\n"
                                             "/P1/S1\t0\t0\t0\t30\n^<S2\t0\t0\t500\t20\n"));
    ASSERT_TRUE(plant) << plant.error().message;
    EXPECT_EQ(plant->node_radius_mm, (std::vector<float> { 30, 20 }));
}

TEST(Mtg, SaysWhatIsWrong)
{
    EXPECT_EQ(error("solid\n"), "tree.mtg:1: this is no MTG: expected CODE: before anything else");
    EXPECT_EQ(error("CODE: FORM-A\n"), "tree.mtg: there is no section MTG: in it");
    auto const in_table = [](std::string const& lines) {
        return error(with_header("ENTITY-CODE\t\tXX\tYY\tZZ\n" + lines));
    };
    EXPECT_EQ(error(with_header("ENTITY-CODE\tXX\tZZ\n")),
              "tree.mtg:20: there is no column YY: a plant needs positions, XX, YY and ZZ");
    EXPECT_EQ(in_table("/P1/Q1\n"), "tree.mtg:21: entity Q1: CLASSES has no class Q");
    EXPECT_EQ(in_table("<S1\n"), "tree.mtg:21: the first entity begins with /");
    EXPECT_EQ(in_table("^/S1\n"),
              "tree.mtg:21: ^ stands for the entity above it, and there is none");
    EXPECT_EQ(in_table("/P1\n^<S1\n"),
              "tree.mtg:22: found <, but there is no entity of this scale for it to stand on");
    EXPECT_EQ(in_table("/P1/S1\t\t1\tx\t3\n"),
              "tree.mtg:21: found x in column 4, expected a number");
    EXPECT_EQ(in_table("/P1/S1\t\t1\t\t3\n"),
              "tree.mtg:21: the position is not complete: XX, YY and ZZ go together");
    EXPECT_EQ(in_table("/P1/S1<<S99999999\n"),
              "tree.mtg:21: << and ++ stand for entities with the numbers between, rising");
    EXPECT_EQ(in_table("\t/P1\n"),
              "tree.mtg:21: the entity is in column 2, expected one of the first 1");
    EXPECT_EQ(in_table("/P1\n"),
              "tree.mtg: there is no branch in it: two positions, one above the other, make one");
}

} // namespace
} // namespace tractus
