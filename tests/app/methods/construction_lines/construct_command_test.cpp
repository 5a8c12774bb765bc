#include "tests/app/methods/construction_lines/construct_folder.h"
#include "tests/corpus.h"

#include <cmath>
#include <string>

namespace tractus::lines {
namespace {

class ConstructCommand : public ConstructFolder { };

std::string sketch(char const* name)
{
    return shipped(fs::path("construction_lines") / name).string();
}

TEST_F(ConstructCommand, WritesAModelWithItsFunctions)
{
    auto const outcome
        = commands::run({ "construct", sketch("hand_spiral.json"), "-o", path("out"), "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    for (auto const* const ending :
         { ".l", ".v", "_heading.func", "_depth.func", "_angle_left.func", "_angle_right.func",
           "_size_left.func", "_size_right.func", "_internode.func", "_leaf.s" })
        EXPECT_TRUE(fs::exists(path("out/hand_spiral") + ending)) << ending;
    auto const checked = commands::run({ "lsystem", "check", path("out/hand_spiral.l") });
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    EXPECT_EQ(checked.err, "");
}

// The exported files must define the same plant: reading them again gives the same bytes.
TEST_F(ConstructCommand, TheExportedTextGivesTheSamePlant)
{
    for (std::string const name : { "hand_decussate", "bent", "deep", "hand_whorled", "cone" }) {
        auto const file = name + ".json";
        ASSERT_EQ(commands::run({ "construct", sketch(file.c_str()), "-o", path(name), "--report" })
                      .exit_code,
                  0);
        ASSERT_EQ(commands::run({ "construct", sketch(file.c_str()), "-o", path(name + ".glb") })
                      .exit_code,
                  0);
        auto const again
            = commands::run({ "grow", path(name + "/" + name + ".l"), "-o", path("again.glb") });
        ASSERT_EQ(again.exit_code, 0) << again.err;
        auto const written = file_bytes(path(name + ".glb"));
        EXPECT_GT(written.size(), 1'000U);
        EXPECT_TRUE(written == file_bytes(path("again.glb"))) << name;
    }
}

// The exported text must also give the same plant if its leaves are surfaces drawn in three views.
// The file of the surfaces is then in the exported folder.
TEST_F(ConstructCommand, TheExportedTextOfOrgansInThreeViewsGivesTheSamePlant)
{
    for (std::string const pattern : { "distichous", "decussate", "spiral", "whorled(3)" }) {
        std::ofstream(folder_ / "petals.json")
            << R"({"pattern":")" << pattern
            << R"(","nodes_per_layer":[5],"stem":[[0,0],[0,200]],"left":[[-40,-9],[-40,350]],
                "inclinations":[[[-60,75],[0,40],[60,75]],[[-60,195],[0,160],[60,195]]],
                "organ":{"left":[[0,0],[-20,30],[0,80]],"right":[[0,0],[20,30],[0,80]],
                "midrib":[[0,0],[40,12],[80,0]],"section":[[-10,4],[0,0],[10,4]]}})";
        ASSERT_EQ(
            commands::run({ "construct", path("petals.json"), "-o", path(pattern), "--report" })
                .exit_code,
            0);
        EXPECT_TRUE(fs::exists(path(pattern + "/petals_organ.s")));
        ASSERT_EQ(
            commands::run({ "construct", path("petals.json"), "-o", path("once.glb") }).exit_code,
            0);
        auto const text = path(pattern + "/petals.l");
        EXPECT_EQ(commands::run({ "lsystem", "check", text }).err, "");
        ASSERT_EQ(commands::run({ "grow", text, "-o", path("again.glb") }).exit_code, 0);
        auto const written = file_bytes(path("once.glb"));
        EXPECT_GT(written.size(), 20'000U);
        EXPECT_TRUE(written == file_bytes(path("again.glb"))) << pattern;
    }
}

// Returns a sketch of a vertical stem with four lines. The boundaries form an elliptic cylinder, 40
// mm wide and 25 mm deep.
std::string in_cylinder(std::string const& pattern, std::string const& lines)
{
    return R"({"pattern":")" + pattern + R"(","nodes_per_layer":[12],"stem":[[0,0],[0,200]],
        "inclinations":[[[-60,75],[0,40],[60,75]],[[-60,195],[0,160],[60,195]]],)"
        + lines + "}";
}

constexpr char const* kFourLines = R"("left":[[-40,-9],[-40,350]],"right":[[40,-9],[40,350]],
    "boundaries":[[[0,-9,25],[0,350,25]],[[0,-9,-25],[0,350,-25]]])";

TEST_F(ConstructCommand, BoundariesInSpaceKeepTheirAzimuths)
{
    std::ofstream(folder_ / "cylinder.json") << in_cylinder("spiral", kFourLines);
    auto const outcome
        = commands::run({ "construct", path("cylinder.json"), "-o", path("out"), "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    auto const report = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(report["leaf_tips"].size(), 13U);
    for (auto const& tip : report["leaf_tips"])
        EXPECT_NEAR(std::hypot(tip[0].get<double>() / 40, tip[2].get<double>() / 25), 1, 0.01);
    ASSERT_EQ(report["boundaries"].size(), 4U);
    EXPECT_NEAR(report["boundaries"][1]["azimuth"].get<double>(), 90, 1e-9);
    double const sine = std::sin(std::atan2(60, 35));
    EXPECT_NEAR(report["boundaries"][3]["size"][10].get<double>(), 25 / 200.0 / sine, 1e-6);
    EXPECT_NEAR(report["functions"]["left_size"][10].get<double>(), 40 / 200.0 / sine, 1e-6);
}

TEST_F(ConstructCommand, TheExportedTextOfBoundariesInSpaceGivesTheSamePlant)
{
    for (std::string const pattern : { "decussate", "spiral", "whorled(5)" }) {
        std::ofstream(folder_ / "cylinder.json") << in_cylinder(pattern, kFourLines);
        ASSERT_EQ(
            commands::run({ "construct", path("cylinder.json"), "-o", path(pattern), "--report" })
                .exit_code,
            0);
        ASSERT_EQ(
            commands::run({ "construct", path("cylinder.json"), "-o", path("once.glb") }).exit_code,
            0);
        auto const text = path(pattern + "/cylinder.l");
        EXPECT_EQ(commands::run({ "lsystem", "check", text }).err, "");
        ASSERT_EQ(commands::run({ "grow", text, "-o", path("again.glb") }).exit_code, 0);
        EXPECT_TRUE(file_bytes(path("once.glb")) == file_bytes(path("again.glb"))) << pattern;
    }
}

// Lines given as strokes, without roles, must be recognised as the same lines. Boundaries are
// recognised by their depth.
TEST_F(ConstructCommand, TellsBoundariesInSpaceByTheirDepth)
{
    auto const functions = [&](std::string const& text) {
        std::ofstream(folder_ / "lines.json") << text;
        auto const outcome
            = commands::run({ "construct", path("lines.json"), "-o", path("out"), "--report" });
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        auto report = nlohmann::json::parse(outcome.out);
        report.erase("roles");
        report.erase("unplaced");
        return report;
    };
    auto const said = functions(in_cylinder("spiral", kFourLines));
    EXPECT_EQ(functions(R"({"pattern":"spiral","nodes_per_layer":[12],"strokes":[[[0,0],[0,200]],
        [[0,-9,25],[0,350,25]],[[-60,75],[0,40],[60,75]],[[-40,-9],[-40,350]],
        [[40,-9],[40,350]],[[0,-9,-25],[0,350,-25]],[[-60,195],[0,160],[60,195]]]})"),
              said);
    auto const leaning = functions(in_cylinder(
        "spiral", R"("left":[[-40,-9,20],[-40,350,20]],"right":[[40,-9,2],[40,350,2]])"));
    ASSERT_EQ(leaning["boundaries"].size(), 2U);
    EXPECT_EQ(leaning["boundaries"][0]["azimuth"], 180);
    EXPECT_NEAR(leaning["boundaries"][1]["azimuth"].get<double>(),
                360 - std::atan2(20, 40) * 180 / 3.14159265, 1e-6);
}

// Between the sizes 0.25 and 0.15 of the boundaries, the half ellipses give 0.2209, 0.2000 and
// 0.1697.
TEST_F(ConstructCommand, SizesMayFollowHalfEllipses)
{
    std::ofstream(folder_ / "round.json")
        << R"({"pattern":"spiral","divergence":45,"sizes":"half-ellipses","nodes_per_layer":[4],
               "stem":[[0,0],[0,200]],"left":[[-50,0],[-50,300]],"right":[[30,0],[30,300]],
               "inclinations":[[[-60,40],[60,40]],[[-60,160],[60,160]]]})";
    auto const reaches = [&](std::vector<std::string> const& options) {
        std::vector<std::string> words { "construct", path("round.json"), "-o", path("out"),
                                         "--report" };
        words.insert(words.end(), options.begin(), options.end());
        auto const outcome = commands::run(words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        std::vector<double> found;
        auto const report = nlohmann::json::parse(outcome.out);
        for (auto const& tip : report["leaf_tips"])
            found.push_back(std::hypot(tip[0].get<double>(), tip[2].get<double>()) / 200);
        return found;
    };
    auto const expect = [](std::vector<double> const& found, std::vector<double> const& wanted) {
        ASSERT_EQ(found.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i)
            EXPECT_NEAR(found[i], wanted[i], 1e-4) << i;
    };
    expect(reaches({}), { 0.25, 0.2209, 0.2, 0.1697, 0.15 });
    expect(reaches({ "--sizes", "linear" }), { 0.25, 0.225, 0.2, 0.175, 0.15 });
}

// If the organs are sketches, the exported text must also give the same plant.
TEST_F(ConstructCommand, OrgansMayBeSketches)
{
    auto const inner = in_cylinder("spiral", kFourLines);
    std::ofstream(folder_ / "inner.json") << inner;
    for (std::string const pattern : { "distichous", "decussate", "spiral", "whorled(3)" }) {
        auto outer = in_cylinder(pattern, kFourLines);
        outer.insert(1, R"("organs":"inner.json",)");
        outer.replace(outer.find("[12]"), 4, "[3]");
        std::ofstream(folder_ / "outer.json") << outer;
        ASSERT_EQ(
            commands::run({ "construct", path("outer.json"), "-o", path(pattern), "--report" })
                .exit_code,
            0);
        ASSERT_EQ(
            commands::run({ "construct", path("outer.json"), "-o", path("once.glb") }).exit_code,
            0);
        auto const text = path(pattern + "/outer.l");
        EXPECT_EQ(commands::run({ "lsystem", "check", text }).err, "");
        ASSERT_EQ(commands::run({ "grow", text, "-o", path("again.glb") }).exit_code, 0);
        EXPECT_TRUE(file_bytes(path("once.glb")) == file_bytes(path("again.glb"))) << pattern;
    }
    auto const report
        = commands::run({ "construct", path("outer.json"), "-o", path("out"), "--report" });
    EXPECT_EQ(nlohmann::json::parse(report.out)["leaf_tips"].size(), 4U * 3 * 13);
}

TEST_F(ConstructCommand, SaysWhichOrganIsWrong)
{
    auto const with = [&](std::string const& organs) {
        auto text = in_cylinder("spiral", kFourLines);
        return refusal(text.insert(1, "\"organs\":" + organs + ","));
    };
    EXPECT_NE(with(R"(["none.json"])").find("none.json"), std::string::npos);
    EXPECT_EQ(with("[7]").substr(0, 43), "organs of layer 1: organs are no sketches: ");
    EXPECT_EQ(with(R"("wrong.json")").substr(0, 23), "it is an organ of itsel");
    std::ofstream(folder_ / "half.json") << R"({"pattern":"spiral","nodes_per_layer":[3]})";
    EXPECT_NE(with(R"([null,"half.json"])").find("half.json: the stem is missing"),
              std::string::npos);
    std::ofstream(folder_ / "clump.json")
        << R"({"pattern":"spiral","nodes_per_layer":[3],"stem":[[0,0],[0,90]],"left":[[-9,0],[-9,90]],
               "stems":[{"stem":[[40,0],[40,90]]}]})";
    EXPECT_NE(with(R"("clump.json")").find("has one stem"), std::string::npos);
}

// Sketch of five stems: a frond, a smaller frond beside it, a lateral axis on the smaller frond,
// and two stems that fork from the top of the first frond.
constexpr char const* kStems = R"({"pattern":"PATTERN","nodes_per_layer":[5],
    "stem":[[0,0],[4,100],[0,200]],"left":[[-60,0],[-40,120],[-5,220]],
    "right":[[50,0],[40,120],[5,220]],
    "inclinations":[[[-60,70],[2,40],[60,80]],[[-40,190],[1,160],[40,190]]],
    "stems":[{"stem":[[120,-10],[130,50],[150,110]]},
             {"stem":[[132,50],[180,70],[200,100]]},
             {"stem":[[1,198],[-30,240],[-40,280]]},
             {"stem":[[0,201],[40,235],[50,270]],"left":[[20,240],[40,290]],
              "right":[[40,205],[70,260]],"nodes_per_layer":[2]}]})";

std::string stems_in(std::string const& pattern)
{
    std::string text(kStems);
    return text.replace(text.find("PATTERN"), 7, pattern);
}

TEST_F(ConstructCommand, TheExportedTextOfSeveralStemsGivesTheSamePlant)
{
    for (std::string const pattern : { "distichous", "decussate", "spiral", "whorled(4)" }) {
        std::ofstream(folder_ / "stems.json") << stems_in(pattern);
        ASSERT_EQ(
            commands::run({ "construct", path("stems.json"), "-o", path(pattern), "--report" })
                .exit_code,
            0);
        ASSERT_EQ(
            commands::run({ "construct", path("stems.json"), "-o", path("once.glb") }).exit_code,
            0);
        auto const text = path(pattern + "/stems.l");
        auto const checked = commands::run({ "lsystem", "check", text });
        EXPECT_EQ(checked.err, "");
        auto const again = commands::run({ "grow", text, "-o", path("again.glb") });
        ASSERT_EQ(again.exit_code, 0) << again.err;
        auto const written = file_bytes(path("once.glb"));
        EXPECT_GT(written.size(), 1'000U);
        EXPECT_TRUE(written == file_bytes(path("again.glb"))) << pattern;
    }
}

TEST_F(ConstructCommand, ReportsEachStem)
{
    std::ofstream(folder_ / "stems.json") << stems_in("distichous");
    auto const outcome
        = commands::run({ "construct", path("stems.json"), "-o", path("out"), "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const report = nlohmann::json::parse(outcome.out);
    auto const& stems = report["stems"];
    ASSERT_EQ(stems.size(), 5U);
    EXPECT_EQ(stems[0]["stem_length"], report["stem_length"]);
    EXPECT_TRUE(stems[1]["stands_on"].is_null());
    EXPECT_EQ(stems[1]["lines"], stems[0]["lines"]) << "the first one's, since it has none";
    EXPECT_EQ(stems[2]["stands_on"], 2);
    EXPECT_NEAR(stems[2]["stands_at"].get<double>(), 0.5, 0.02);
    EXPECT_EQ(stems[3]["stands_on"], 1);
    EXPECT_EQ(stems[3]["stands_at"], 1);
    EXPECT_EQ(stems[4]["node_x"].size(), 3U) << "its own: no inclination lines, two nodes";
    // Each node has two leaf tips. The first four stems have six nodes each, the last one has
    // three.
    EXPECT_EQ(report["leaf_tips"].size(), 2U * (4 * 6 + 3));
}

TEST_F(ConstructCommand, TellsTheStrokesOfSeveralStems)
{
    std::ofstream(folder_ / "strokes.json")
        << R"({"pattern":"distichous","nodes_per_layer":[4],"strokes":[[[0,0],[0,200]],
               {"stem":[[140,0],[140,150]]},[[-60,160],[40,160]],[[40,80],[0,40],[-60,100]],
               [[180,0],[170,170]],[[-50,0],[-50,300]],{"stem":[[2,120],[90,170]]}]})";
    auto const outcome
        = commands::run({ "construct", path("strokes.json"), "-o", path("told"), "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const told = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(told["roles"],
              (std::vector<std::string> { "stem", "stem", "inclination", "inclination", "right",
                                          "left", "stem" }));
    EXPECT_EQ(told["stroke_stems"], (std::vector<int> { 1, 2, 1, 1, 2, 1, 3 }));
    EXPECT_EQ(told["stems"][2]["stands_on"], 1);
    EXPECT_EQ(told["stems"][2]["node_x"], told["stems"][0]["node_x"]);
}

TEST_F(ConstructCommand, SaysWhatIsWrongWithAStem)
{
    EXPECT_EQ(refusal(R"({"pattern":"spiral","nodes_per_layer":[3],"stem":[[0,0],[0,9]],
                          "left":[[-3,0],[-3,9]],"stems":[{"left":[[0,0],[0,9]]}]})"),
              "stem 2 has no line: write {\"stem\": [[u, v], [u, v]]}\n");
    EXPECT_EQ(refusal(R"({"pattern":"spiral","nodes_per_layer":[3],"stem":[[0,0],[0,9]],
                          "left":[[-3,0],[-3,9]],"stems":[{"stem":[[4,4],[4,4]]}]})"),
              "stem 2: the stem is missing or only a dot: draw it from the plant's foot to its "
              "top, as the first line\n");
    EXPECT_EQ(refusal(R"({"pattern":"spiral","nodes_per_layer":[3],"strokes":[{"left":[]}]})"),
              "stroke 1 is no line: write [[u, v], [u, v]], or {\"stem\": [[u, v], [u, v]]} for "
              "another stem\n");
}

// In an SVG drawing, lines belong to the stem that precedes them.
TEST_F(ConstructCommand, ReadsSeveralStemsFromAnSvgDrawing)
{
    std::ofstream(folder_ / "drawn.svg")
        << R"(<svg xmlns="http://www.w3.org/2000/svg" width="100mm" viewBox="0 0 100 300">
              <path id="stem" d="M0 0V-200"/><path id="left" d="M-50 0V-300"/>
              <path id="another-stem" d="M100 0V-100"/><path id="right2" d="M130 0V-150"/></svg>)";
    auto const drawn = commands::run({ "construct", path("drawn.svg"), "--pattern", "distichous",
                                       "--nodes", "4", "-o", path("drawn"), "--report" });
    ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
    auto const report = nlohmann::json::parse(drawn.out);
    ASSERT_EQ(report["stems"].size(), 2U);
    // Leaves at 45 degrees to their stem reach the boundaries, which are 0.25 and 0.3 of the stem's
    // length away from it.
    EXPECT_NEAR(report["stems"][0]["functions"]["left_size"][9].get<double>(),
                0.25 * std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(report["stems"][1]["functions"]["right_size"][9].get<double>(),
                0.3 * std::sqrt(2.0), 1e-6);
}

TEST_F(ConstructCommand, WritesAGraphThatIsAPlant)
{
    ASSERT_EQ(commands::run({ "construct", sketch("bent.json"), "-o", path("bent.mtg") }).exit_code,
              0);
    auto const grown = commands::run({ "grow", path("bent.mtg"), "-o", path("again.mtg") });
    ASSERT_EQ(grown.exit_code, 0) << grown.err;
    EXPECT_FALSE(fs::is_directory(path("bent.mtg")));
}

TEST_F(ConstructCommand, ASketchIsReadAsASessionAgain)
{
    ASSERT_EQ(commands::run(
                  { "construct", sketch("bent.json"), "-o", path("out"), "--report", "--session" })
                  .exit_code,
              0);
    auto const grown = commands::run({ "session", "info", path("out/bent.tractus") });
    EXPECT_EQ(grown.exit_code, 0) << grown.err;
}

TEST_F(ConstructCommand, ASessionNeedsAFolder)
{
    auto const outcome
        = commands::run({ "construct", sketch("bent.json"), "-o", path("plant.glb"), "--session" });
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("plant.glb: a session needs a folder"), std::string::npos);
    EXPECT_FALSE(fs::exists(path("plant.glb")));
}

TEST_F(ConstructCommand, SmoothsHandDrawnLines)
{
    auto const plain
        = commands::run({ "construct", sketch("bent.json"), "-o", path("a"), "--report" });
    auto const smooth = commands::run(
        { "construct", sketch("bent.json"), "-o", path("b"), "--report", "--smooth" });
    ASSERT_EQ(smooth.exit_code, 0) << smooth.err;
    auto const drawn = nlohmann::json::parse(plain.out);
    auto const meant = nlohmann::json::parse(smooth.out);
    EXPECT_NE(drawn["lines"], meant["lines"]);
    EXPECT_NEAR(drawn["lines"][0].get<double>(), meant["lines"][0].get<double>(), 0.02);
}

TEST_F(ConstructCommand, SaysWhatIsWrongWithASketch)
{
    EXPECT_EQ(refusal(R"({"stem":[[0,0],[0,9]]})"),
              "pattern is missing: give \"distichous\", \"decussate\", \"spiral\", "
              "\"alternate\", or \"whorled(N)\" with N from 2 to 24\n");
    EXPECT_EQ(refusal(R"({"pattern":"spiral","stem":[[0,0],[0,9]]})"),
              "nodes_per_layer is missing: give the number of nodes of each layer between two "
              "neighbouring inclination lines, such as [5], or --nodes 5\n");
    EXPECT_EQ(refusal(R"({"pattern":"spiral","nodes_per_layer":[3]})"),
              "the stem is missing or only a dot: draw it from the plant's foot to its top, as the "
              "first line\n");
    auto const nothing = commands::run({ "construct", path("none.json"), "-o", path("out") });
    EXPECT_EQ(nothing.exit_code, 1);
    EXPECT_NE(nothing.err.find("none.json"), std::string::npos) << nothing.err;
}

TEST_F(ConstructCommand, SaysWhatIsWrongWithBoundariesInSpace)
{
    auto const with
        = [&](std::string const& words) { return refusal(in_cylinder("spiral", words)); };
    EXPECT_EQ(with(R"("boundaries":[[0,1]])"),
              "point 1 of boundary 1 is no point: write [u, v] in millimetres\n");
    EXPECT_EQ(with(R"("boundaries":7)").substr(0, 40), "boundaries is no list of at most 100 lin");
    EXPECT_EQ(with(R"("boundaries":[[[0,0,1e-9],[0,200,0]]])").substr(0, 45),
              "boundary 1 in space goes along the stem or ar");
    EXPECT_EQ(with(R"("sizes":"round")").substr(0, 34), "sizes is no way to change around t");
}

TEST_F(ConstructCommand, SaysWhatItHadToGuess)
{
    std::ofstream(folder_ / "half.json")
        << R"({"pattern":"alternate","name":"half a frond","stem":[[0,0],[0,90]],
               "left":[[-30,0],[-20,120]],"nodes_per_layer":[6]})";
    auto const outcome
        = commands::run({ "construct", path("half.json"), "-o", path("out"), "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("\"name\" is left out"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("the right boundary is missing"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("there are no inclination lines"), std::string::npos) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["notes"].size(), 2U);
}

TEST_F(ConstructCommand, TellsStrokesThatDoNotSayWhatTheyAre)
{
    std::ofstream(folder_ / "strokes.json")
        << R"({"pattern":"spiral","nodes_per_layer":[4],"strokes":[[[0,0],[0,200]],
               [[40,160],[-60,160]],[[30,300],[30,0]],[[90,90],[99,99]],[[-50,0],[-50,300]],
               [[-60,100],[0,40],[40,80]]]})";
    auto const outcome
        = commands::run({ "construct", path("strokes.json"), "-o", path("told"), "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("stroke 4 is left out: this line neither"), std::string::npos)
        << outcome.err;
    auto const told = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(told["roles"],
              (std::vector<std::string> { "stem", "inclination", "right", "unsure", "left",
                                          "inclination" }));
    auto const said = nlohmann::json::parse(
        commands::run({ "construct", sketch("hand_spiral.json"), "-o", path("said"), "--report" })
            .out);
    EXPECT_EQ(told["functions"], said["functions"]);
    EXPECT_EQ(told["leaf_tips"], said["leaf_tips"]);
    EXPECT_EQ(
        refusal(R"({"pattern":"spiral","nodes_per_layer":[1],"strokes":[],"stem":[]})"),
        "strokes are there and stem, too: leave out stem, or call each of the strokes what it "
        "is\n");
    EXPECT_EQ(refusal(R"({"pattern":"spiral","nodes_per_layer":[1],"strokes":[[[1,2],[1,2]]]})"),
              "stroke 1 is only a dot: leave it out\n");
}

// A palm: its boundaries enclose only the crown, so they belong to a part of the stem.
TEST_F(ConstructCommand, TakesStrokesAsTheyAreDrawn)
{
    std::ofstream(folder_ / "palm.json")
        << R"({"strokes":[[[60,175],[48,210],[20,240],[3,246]],[[0,0],[0,120],[0,240]],
               [[-60,172],[-50,205],[-30,226]],[[-29,227],[-15,240],[-2,247]],
               [[-70,200],[0,180],[70,200]],[[-40,250],[0,222],[40,250]],[[190,20],[196,26]]]})";
    auto const outcome
        = commands::run({ "construct", path("palm.json"), "-o", path("palm"), "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("stroke 7 is left out"), std::string::npos) << outcome.err;
    auto const told = nlohmann::json::parse(outcome.out);
    nlohmann::json const piece { { "role", "left" }, { "of", 3 } };
    EXPECT_EQ(
        told["roles"],
        nlohmann::json({ "right", "stem", "left", piece, "inclination", "inclination", "unsure" }));
    EXPECT_EQ(told["unplaced"], nlohmann::json({ 7 }));
    // The two rows have leaves on nine nodes: the eight that the pen's lines have by default, and
    // one more.
    EXPECT_EQ(told["leaf_tips"].size(), 2U * 9);
}

// An SVG drawing and a list of coordinates must be read as the same sketch.
TEST_F(ConstructCommand, ReadsAnSvgDrawing)
{
    std::ofstream(folder_ / "drawn.svg")
        << R"(<svg xmlns="http://www.w3.org/2000/svg" width="100mm" viewBox="0 0 100 300">
              <path d="M0 0V-200"/><path d="M-50 0V-300"/><path d="M-60-100 0-40 40-80"/>
              <path d="M30 0V-300"/><path d="M-60-160H40"/></svg>)";
    auto const drawn = commands::run({ "construct", path("drawn.svg"), "--pattern", "spiral",
                                       "--nodes", "4", "-o", path("drawn"), "--report" });
    ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
    auto const written = commands::run(
        { "construct", sketch("hand_spiral.json"), "-o", path("written"), "--report" });
    auto report = nlohmann::json::parse(drawn.out);
    report.erase("roles");
    EXPECT_EQ(report["unplaced"], nlohmann::json::array());
    report.erase("unplaced");
    EXPECT_EQ(report, nlohmann::json::parse(written.out));
    auto const without = commands::run({ "construct", path("drawn.svg"), "-o", path("drawn") });
    // The defaults of lines drawn with the pen apply: two rows and 8 nodes.
    EXPECT_EQ(without.exit_code, 0) << without.err;
}

TEST_F(ConstructCommand, WhatIsGivenBesidesCountsInPlaceOfTheSketchs)
{
    auto const outcome
        = commands::run({ "construct", "--pattern", "whorled(5)", "--nodes", "2,1", "-o",
                          path("out"), "--report", sketch("hand_layers.json") });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["node_x"].size(), 4U);
    EXPECT_EQ(report["leaf_tips"].size(), 20U);
}

// A sketch of the maximum size must be accepted.
TEST_F(ConstructCommand, TakesTheLargestSketch)
{
    nlohmann::json file { { "pattern", "distichous" } };
    for (int i = 0; i < 5'000; ++i) {
        file["stem"].push_back({ 0.3 * (i % 2), 0.1 * i });
        file["left"].push_back({ -90 + i % 7, 0.2 * i });
        file["right"].push_back({ 90 - i % 5, 0.2 * i });
    }
    for (int line = 0; line <= 20; ++line) {
        std::vector<std::vector<double>> points;
        for (int i = 0; i < 200; ++i)
            points.push_back({ -100.0 + i, 20.05 + 20 * line });
        file["inclinations"].push_back(points);
    }
    file["nodes_per_layer"] = std::vector<int>(20, 499);
    std::ofstream(folder_ / "large.json") << file;
    auto const outcome
        = commands::run({ "construct", path("large.json"), "-o", path("out"), "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["leaf_tips"].size(), 2U * (20 * 499 + 1));
}

} // namespace
} // namespace tractus::lines
