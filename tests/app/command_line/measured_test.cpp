#include "tests/app/command_line/workshop.h"
#include "tests/file_bytes.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <vector>

namespace tractus {
namespace {

// Table of cylinders with named columns. Its tree, which the texts below repeat in other formats,
// is 4 m high: a trunk of three pieces, and a branch of two pieces on the trunk's first piece.
constexpr char const* kNamedCylinders
    = "ID, parentID, startX, startY, startZ, endX, endY, endZ, radius\n"
      "0, -1, 7, 3, 100, 7, 3, 101, 0.2\n1, 0, 7, 3, 101, 7, 3, 102.5, 0.15\n"
      "2, 1, 7, 3, 102.5, 7, 3, 104, 0.1\n3, 0, 7, 3, 101, 8, 3, 101.5, 0.05\n"
      "4, 3, 8, 3, 101.5, 9, 3, 102, 0.04\n";
// The tree as cylinders in the format of TreeQSM 2.3.
constexpr char const* kCylinders = "0.2\t1\t7\t3\t100\t0\t0\t1\t0\t2\t0\t0.2\t1\t0\t1\n"
                                   "0.15\t1.5\t7\t3\t101\t0\t0\t1\t1\t3\t0\t0.15\t1\t0\t2\n"
                                   "0.1\t1.5\t7\t3\t102.5\t0\t0\t1\t2\t0\t0\t0.1\t1\t0\t3\n"
                                   "0.05\t1.118\t7\t3\t101\t2\t0\t1\t1\t5\t1\t0.05\t2\t1\t1\n"
                                   "0.04\t1.118\t8\t3\t101.5\t2\t0\t1\t4\t0\t0\t0.04\t2\t1\t2\n";
constexpr char const* kGraph
    = "CODE:\tFORM-A\n\nCLASSES:\nSYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\t"
      "DEFINITION\n$\t0\tFREE\tFREE\tIMPLICIT\nP\t1\tFREE\tFREE\tEXPLICIT\n"
      "S\t2\tFREE\tFREE\tEXPLICIT\n\nDESCRIPTION:\nLEFT\tRIGHT\tRELTYPE\tMAX\n"
      "S\tS\t+\t?\nS\tS\t<\t1\n\nFEATURES:\nNAME\tTYPE\nXX\tREAL\nYY\tREAL\n"
      "ZZ\tREAL\nTopDia\tREAL\n\nMTG:\nENTITY-CODE\t\tXX\tYY\tZZ\tTopDia\n"
      "/P1/S1\t\t7\t3\t100\t0.4\n^<S2\t\t7\t3\t101\t0.4\n"
      "\t+S1\t8\t3\t101.5\t0.1\n\t^<S2\t9\t3\t102\t0.08\n"
      "^<S3\t\t7\t3\t102.5\t0.3\n^<S4\t\t7\t3\t104\t0.2\n";

void append(std::string& bytes, auto value)
{
    std::array<char, sizeof value> raw {};
    std::memcpy(raw.data(), &value, sizeof value);
    bytes.append(raw.data(), raw.size());
}

// Returns the tree as a PLY skeleton in little-endian byte order, as on all supported machines.
std::string skeleton()
{
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex 6\n"
                        "property float x\nproperty float y\nproperty float z\n"
                        "property float radius\nelement edge 5\n"
                        "property list uchar int vertex_indices\nend_header\n";
    for (float const value :
         { 7.F, 3.F, 100.F, 0.2F, 7.F, 3.F, 101.F,  0.2F,  7.F, 3.F, 102.5F, 0.15F,
           7.F, 3.F, 104.F, 0.1F, 8.F, 3.F, 101.5F, 0.05F, 9.F, 3.F, 102.F,  0.04F })
        append(bytes, value);
    constexpr std::array<std::array<std::int32_t, 2>, 5> kEdges {
        { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 1, 4 }, { 4, 5 } }
    };
    for (auto const& edge : kEdges) {
        append(bytes, std::uint8_t { 2 });
        append(bytes, edge[0]);
        append(bytes, edge[1]);
    }
    return bytes;
}

class Measured : public Workshop {
protected:
    void SetUp() override
    {
        Workshop::SetUp();
        write("named.csv", kNamedCylinders);
        write("cylinders.txt", kCylinders);
        write("graph.mtg", kGraph);
        write("skeleton.ply", skeleton());
        write("arc.toml",
              "version = 1\nseed = 3\n[[gesture]]\ntool = \"select\"\ntrace = \"axis\"\naxis = 0\n"
              "[[gesture]]\ntool = \"draw\"\npropagation = \"selected\"\npath = \"branch\"\n"
              "from_mm = [0, 0, 20]\nlength_mm = 180\nheading_deg = 0\nelevation_deg = 90\n"
              "turn_deg = 0\nbend_deg = -90\n");
    }

    std::string out(std::string const& command) const
    {
        auto const outcome = run(command);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return outcome.out;
    }

    // Returns the positions of the entities in a multiscale tree graph, in millimetres and in the
    // order of the file.
    std::vector<std::array<double, 3>> positions(std::string const& graph) const
    {
        std::vector<std::array<double, 3>> result;
        std::istringstream lines(read(graph));
        bool is_entity = false;
        std::size_t first = 0;
        for (std::string line; std::getline(lines, line);) {
            std::vector<std::string> cells;
            std::istringstream rest(line);
            for (std::string cell; std::getline(rest, cell, '\t');)
                cells.push_back(cell);
            if (is_entity && cells.size() > first + 2 && !cells[first].empty())
                result.push_back({ std::stod(cells[first]), std::stod(cells[first + 1]),
                                   std::stod(cells[first + 2]) });
            is_entity |= line.starts_with("ENTITY-CODE");
            if (line.starts_with("ENTITY-CODE"))
                first = static_cast<std::size_t>(std::find(cells.begin(), cells.end(), "XX")
                                                 - cells.begin());
        }
        return result;
    }

    static bool has(std::vector<std::array<double, 3>> const& positions,
                    std::array<double, 3> const& wanted, double tolerance_mm)
    {
        return std::any_of(positions.begin(), positions.end(), [&](auto const& each) {
            return std::hypot(each[0] - wanted[0], each[1] - wanted[1], each[2] - wanted[2])
                < tolerance_mm;
        });
    }

    // Checks that the hand of arc.toml has bent the trunk into a quarter of a circle. The tip of a
    // quarter circle is 2 / pi times its length to the side and as far up.
    void expect_bent(std::string const& graph) const
    {
        double const wanted_mm = 4000 * 2 / 3.14159;
        EXPECT_TRUE(has(positions(graph), { wanted_mm, 0, wanted_mm }, 200)) << read(graph);
    }

    std::vector<std::string> const files { "named.csv", "cylinders.txt", "graph.mtg",
                                           "skeleton.ply" };
};

TEST_F(Measured, EveryFormatGivesTheSameTreeInItsOwnSize)
{
    for (auto const& file : files) {
        auto const said = out("tractus grow " + file + " -o tree.glb");
        EXPECT_EQ(said.find("tree.glb: 5 segments, 0 organs, "), 0u) << file << said;
        EXPECT_EQ(out("tractus grow " + file + " -o tree.mtg"), "tree.mtg: 5 segments, 0 organs\n");
        auto const found = positions("tree.mtg");
        for (auto const& wanted : std::vector<std::array<double, 3>> { { 0, 0, 1000 },
                                                                       { 0, 0, 2500 },
                                                                       { 0, 0, 4000 },
                                                                       { 1000, 0, 1500 },
                                                                       { 2000, 0, 2000 } })
            EXPECT_TRUE(has(found, wanted, 0.1)) << file << wanted[0] << ' ' << wanted[2];
    }
}

TEST_F(Measured, AGraphThatWasWrittenGivesThePlantBack)
{
    out("tractus grow small.l -o first.mtg; tractus grow first.mtg -o second.mtg");
    EXPECT_EQ(positions("first.mtg").size(), 11u);
    EXPECT_EQ(read("second.mtg"), read("first.mtg"));
}

TEST_F(Measured, AGraphGivesItsOrgansBackAndNamesThoseItCannotPlace)
{
    write("leafy.l",
          "Lsystem: 1\nderivation length: 0\nAxiom: F(10)[+(60)~l(5)]F(10)[-(60)~l(3)]F(8)\n"
          "A --> A\nendlsystem\n");
    write("leafy.v",
          "material: 1 green kind=leaf color=0.2,0.6,0.1\n"
          "organ: l leaf kind=blade material=1 length=2 width=1\n");
    EXPECT_EQ(out("tractus grow leafy.l -o first.mtg"), "first.mtg: 3 segments, 2 organs\n");
    EXPECT_EQ(out("tractus grow first.mtg -o second.mtg"), "second.mtg: 3 segments, 2 organs\n");
    EXPECT_EQ(positions("second.mtg"), positions("first.mtg"));
    auto graph = read("first.mtg");
    graph.replace(graph.find("DirectionX\tD"), 10, "DirectionU");
    graph.replace(graph.find("\nL\t3"), 3, "\nLeaf\t");
    for (auto at = graph.find("+L"); at != std::string::npos; at = graph.find("+L", at + 2))
        graph.replace(at, 2, "+Leaf");
    write("foreign.mtg", graph);
    auto const outcome = run("tractus grow foreign.mtg -o third.mtg");
    EXPECT_EQ(outcome.out, "third.mtg: 3 segments, 0 organs\n");
    EXPECT_NE(outcome.err.find("length in it: 2 Leaf"), std::string::npos) << outcome.err;
}

TEST_F(Measured, AStrokeShapesAnAxis)
{
    for (auto const& file : files) {
        run("rm -f arc.tractus-log");
        out("tractus record --simulate arc.toml --plant " + file + " -o arc.tractus-log; "
            + "tractus grow " + file + " --drawing arc.tractus-log -o bent.mtg");
        expect_bent("bent.mtg");
    }
}

TEST_F(Measured, ASessionNeedsNoOtherFileAndGivesItBack)
{
    write("strokes.txt", kCylinders);
    auto all = files;
    all.emplace_back("strokes.txt");
    for (auto const& file : all) {
        out("tractus record --simulate arc.toml --plant " + file + " -o " + file
            + ".tractus-log; tractus replay " + file + ".tractus-log --plant " + file
            + " --count 1 -o out --session " + file + ".tractus; tractus grow " + file
            + ".tractus -o before.glb");
        auto const bytes = read(file);
        run("rm " + file + ' ' + file + ".tractus-log");
        auto const session = file + ".tractus";
        out("tractus grow " + session + " -o after.glb; tractus grow " + session
            + " --growth 'as drawn' -o bent.mtg");
        expect_bent("bent.mtg");
        EXPECT_FALSE(read("before.glb").empty());
        EXPECT_EQ(read("after.glb"), read("before.glb")) << file;
        auto const log = out("tractus session log " + session);
        EXPECT_NE(log.find("takes the measured plant " + file + ": " + std::to_string(bytes.size())
                           + " bytes of "),
                  std::string::npos)
            << log;
        auto const info = out("tractus session info " + session);
        EXPECT_NE(info.find("branches with strokes 1\n"), std::string::npos) << info;
        EXPECT_NE(info.find("without a branch      0\n"), std::string::npos) << info;

        run("mkdir files");
        out("tractus session export " + session + " -o files");
        EXPECT_EQ(read("files/" + (file == "strokes.txt" ? "strokes.csv" : file)), bytes) << file;
        EXPECT_TRUE(exists("files/strokes.txt"));
        run("rm -r files");
    }
}

TEST_F(Measured, MakesACollection)
{
    out("tractus vary named.csv --count 3 -o trees");
    EXPECT_NE(read("trees/named-1.glb").size(), 0u);
    EXPECT_NE(read("trees/named-1.glb"), read("trees/named-2.glb"));
}

TEST_F(Measured, ATextThatIsAModelStaysOne)
{
    run("cp small.l small.txt");
    out("tractus grow small.l -o model.mtg; tractus grow small.txt -o text.mtg");
    EXPECT_EQ(read("text.mtg"), read("model.mtg"));
    EXPECT_EQ(run("tractus grow small.txt --steps 0 -o text.glb").exit_code, 0);
}

TEST_F(Measured, TheContentCountsMoreThanTheEnding)
{
    write("graph.txt", "\xef\xbb\xbf# exported\r\n" + std::string(kGraph));
    write("skeleton.TXT", skeleton());
    for (char const* const file : { "graph.txt", "skeleton.TXT" })
        EXPECT_EQ(out(std::string("tractus grow ") + file + " -o tree.mtg"),
                  "tree.mtg: 5 segments, 0 organs\n");
}

TEST_F(Measured, WhatIsNoTreeIsSaidInOneSentenceAndNothingIsWritten)
{
    std::string const header = "ply\nformat ascii 1.0\nelement vertex ";
    std::vector<std::array<std::string, 3>> const bad {
        { "empty.csv", "", "there is no branch in it" },
        { "points.txt", "0 0 0\n0 0 200\n", "points.txt:1: the line has 3 columns, expected at" },
        { "letter.txt", "Dear botanist,\nhow tall is it?\n", "letter.txt:2: the line has 1 " },
        { "loop.csv",
          "id,parent,start_x,start_y,start_z,end_x,end_y,end_z,radius\n"
          "1,2,0,0,0,0,0,1,1\n2,1,0,0,1,0,0,2,1\n",
          "2 of 2 cylinders stand on each other" },
        { "wide.csv", std::string("\xff\xfe", 2), "text in UTF-16" },
        { "mesh.ply", header + "1\nproperty float x\nend_header\n1\n", "there are no edges in it" },
        { "large.ply", header + "4000000000\nproperty float x\nend_header\n1\n",
          "the file ends before its last element" },
        { "cut.ply", skeleton().substr(0, 260), "the file ends before its last element" },
        { "none.ply", "solid tree\n", "this is no PLY file" },
        { "flat.mtg", "CODE:\tFORM-A\nMTG:\nENTITY-CODE\tLength\n/P1\t3\n", "XX, YY" },
        { "none.mtg", "tree\n", "this is no MTG" },
        { "scan.las", "LASF", "points of a scanner are no tree yet" },
        { "tree.mat", "MATLAB 5.0 MAT-file", "MATLAB's own files are not read" },
    };
    record();
    for (auto const& [name, text, what] : bad) {
        write(name, text);
        for (std::string const& command :
             { "grow " + name + " -o x.glb", "vary " + name + " --count 1 -o x.glb",
               "record --simulate hand.toml --plant " + name + " -o x.glb",
               "replay hand.tractus-log --plant " + name + " -o x.glb --session x.tractus" })
            expect_error(run("tractus " + command), 1, what);
        EXPECT_FALSE(exists("x.glb")) << name;
        EXPECT_FALSE(exists("x.tractus")) << name;
    }
}

TEST_F(Measured, OptionsOfModelsAreRefused)
{
    expect_error(run("tractus grow named.csv --steps 3 -o x.glb"), 1, "named.csv is no L-system");
    expect_error(run("tractus grow named.csv --environment light -o x.glb"), 1, "is no L-system");
    EXPECT_FALSE(exists("x.glb"));
}

// Writes the tree of the manual's page, and runs the page's commands as a reader would copy them.
TEST_F(Measured, TheManualsCommandsWork)
{
    std::string const page = file_bytes(TRACTUS_MANUAL "/models.md");
    auto const section = page.find("\n## A measured tree");
    ASSERT_NE(section, std::string::npos);
    auto const block = [&](std::string const& begin, std::size_t from) {
        auto const at = page.find(begin, from) + begin.size();
        return page.substr(at, page.find("\n```", at) + 1 - at);
    };
    write("ash.csv", block("\n```\n", section));
    std::istringstream commands(block("\n```sh\n", section));
    std::size_t count = 0;
    for (std::string command; std::getline(commands, command); ++count)
        if (!command.starts_with("tractus window")) // The command "window" needs a display.
            out(command);
    EXPECT_GE(count, 3u);
    EXPECT_EQ(read("ash.png").substr(1, 3), "PNG");
}

} // namespace
} // namespace tractus
