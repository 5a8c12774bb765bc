#include "tests/app/methods/construction_lines/construct_folder.h"

// Tests of sketch files that give each layer its own organs.

namespace tractus::lines {
namespace {

class LayerOrgansCommand : public ConstructFolder {
protected:
    // Writes the sketch of a foxglove: a layer of leaves in decussate pairs, and above it a spike
    // of bells.
    std::string foxglove(std::string const& organs, std::string const& more = "")
    {
        std::ofstream(folder_ / "foxglove.json")
            << R"({"pattern":"decussate","nodes_per_layer":[3,6],"stem":[[0,0],[2,120],[0,240]],
                   "left":[[-60,-9],[-35,120],[-6,260]],"right":[[60,-9],[35,120],[6,260]],
                   "inclinations":[[[-90,60],[0,10],[90,60]],[[-60,110],[2,90],[60,110]],
                                   [[-30,250],[0,230],[30,250]]],"organs":)"
            << organs << more << "}";
        return path("foxglove.json");
    }

    // Returns the text of the model written for a sketch, after checking that it gives the same
    // plant.
    std::string text_of(std::string const& sketch)
    {
        auto const made = commands::run({ "construct", sketch, "-o", path("made"), "--report" });
        EXPECT_EQ(made.exit_code, 0) << made.err;
        EXPECT_EQ(made.err, "");
        EXPECT_EQ(commands::run({ "construct", sketch, "-o", path("once.glb") }).exit_code, 0);
        auto const text = path("made/foxglove.l");
        EXPECT_EQ(commands::run({ "lsystem", "check", text }).err, "");
        EXPECT_EQ(commands::run({ "grow", text, "-o", path("again.glb") }).exit_code, 0);
        EXPECT_GT(file_bytes(path("once.glb")).size(), 1'000U);
        EXPECT_TRUE(file_bytes(path("once.glb")) == file_bytes(path("again.glb")));
        return file_bytes(text);
    }
};

constexpr char const* kBell = R"({"left":[[0,0],[-9,4],[-7,20]],"right":[[0,0],[9,4],[7,20]],
    "section":[[-9,8],[0,0],[9,8]],"color":"#a050a0"})";

TEST_F(LayerOrgansCommand, TheExportedTextOfLayersGivesTheSamePlant)
{
    for (auto const* const upper : { "distichous", "spiral", "alternate", "whorled(4)" }) {
        auto const text = text_of(foxglove(
            fmt::format(R"([null, {{"pattern":"{}","face":"down","organ":{}}}])", upper, kBell)));
        EXPECT_NE(text.find("array organ[2] = {0, 1}"), std::string::npos);
        EXPECT_NE(text.find("array roll[2] = {-90, 90}"), std::string::npos);
        EXPECT_TRUE(fs::exists(path("made/foxglove_organ_1.s")));
    }
}

TEST_F(LayerOrgansCommand, LayersOfSeveralStemsGiveTheSamePlant)
{
    auto const text = text_of(foxglove(
        fmt::format(R"#([{{"pattern":"spiral"}}, {{"pattern":"whorled(3)","organ":{}}}])#", kBell),
        R"(,"stems":[{"stem":[[160,0],[170,90],[165,180]]},{"stem":[[1,60],[60,130]]}])"));
    EXPECT_NE(text.find("pattern"), std::string::npos);
}

// The layers of one stem have leaves, a surface, and plants of another sketch as organs.
TEST_F(LayerOrgansCommand, LayersMayBearAnything)
{
    std::ofstream(folder_ / "flower.json")
        << R"#({"pattern":"whorled(5)","stem":[[0,0],[0,20]],"left":[[-12,0],[-12,40]],
                "right":[[12,0],[12,40]],"nodes_per_layer":[0],
                "inclinations":[[[-20,18],[0,8],[20,18]],[[-20,28],[0,18],[20,28]]],"organ":)#"
        << kBell << "}";
    auto const sketch = foxglove(fmt::format(R"([{}, "flower.json"])", kBell), R"(,"face":"up")");
    text_of(sketch);
    auto const report = commands::run({ "construct", sketch, "-o", path("told"), "--report" });
    // Three nodes have two leaves each. Seven nodes have two flowers each, of one node with five
    // petals.
    EXPECT_EQ(nlohmann::json::parse(report.out)["leaf_tips"].size(), 3U * 2 + 7 * 2 * 5);
    auto const made = commands::run({ "construct", sketch, "-o", path("all") });
    EXPECT_NE(made.out.find(" 3 .s, .png"), std::string::npos) << made.out;
}

TEST_F(LayerOrgansCommand, SaysWhatIsWrongWithALayer)
{
    auto const with = [&](std::string const& organs) {
        foxglove(organs);
        return refusal(file_bytes(path("foxglove.json")));
    };
    EXPECT_EQ(with(R"([{"pattern":"round"}])").substr(0, 36),
              "organs of layer 1: pattern is \"round");
    EXPECT_EQ(
        with(R"([null, {"face":"left"}])"),
        "organs of layer 2: face is no way to turn organs: give \"flat\", \"up\" or \"down\"\n");
    EXPECT_EQ(with(R"([{"pattern":"spiral","size":3}])"),
              "organs of layer 1: a layer of organs has no \"size\": give pattern, divergence, "
              "face, organ\n");
    EXPECT_EQ(with(R"({"left":[[0,0],[0,9]],"top":[]})"),
              "organ has no \"top\": give left, right, midrib, section, color, texture\n");
    EXPECT_EQ(with(R"({"left":[[0,0],[0,9]],"right":[[2,0],[2,9]],"color":"red"})"),
              "color of the organ is no colour: give \"#rrggbb\", such as \"#c05080\"\n");
    EXPECT_EQ(with(R"([{"pattern":"spiral","divergence":400}])"),
              "organs of layer 1: divergence is no angle: give degrees from -360 to 360\n");
}

// A leaf may be a file beside the sketch or one that comes with the program. It may be given for
// one layer or for all leaves.
TEST_F(LayerOrgansCommand, ALeafIsAFileOrOneOfOurs)
{
    std::ofstream(folder_ / "mine.organ") << "tractus-organ 1\ncolor #a050a0\n"
                                             "left 0 0  -9 4  -7 20\nright 0 0  9 4  7 20\n"
                                             "section -9 8  0 0  9 8\n";
    auto const of_views = text_of(foxglove(fmt::format("[null, {}]", kBell)));
    auto const surface = file_bytes(path("made/foxglove_organ_1.s"));
    EXPECT_EQ(text_of(foxglove(R"([null, "mine.organ"])")), of_views);
    EXPECT_TRUE(file_bytes(path("made/foxglove_organ_1.s")) == surface);
    text_of(foxglove(R"([null, "bell"])", R"(,"organ":"mine.organ")"));
    EXPECT_FALSE(file_bytes(path("made/foxglove_organ_1.s")) == surface);
    EXPECT_TRUE(file_bytes(path("made/foxglove_organ.s")) == surface);
}

TEST_F(LayerOrgansCommand, SaysWhichLeafIsNotThere)
{
    auto const said = [&](std::string const& organs, std::string const& more = "") {
        auto const outcome
            = commands::run({ "construct", foxglove(organs, more), "-o", path("out") });
        EXPECT_EQ(outcome.exit_code, 1);
        return outcome.err;
    };
    EXPECT_NE(said(R"([null, "hart"])")
                  .find("there is no leaf in three views \"hart\": give the "
                        "path of a file (.organ), or one of bell, heart"),
              std::string::npos);
    EXPECT_NE(said(R"([null, "none.organ"])").find("none.organ"), std::string::npos);
    std::ofstream(folder_ / "odd.organ") << "tractus-organ 1\nleft 0 0\n";
    EXPECT_NE(said("[null]", R"(,"organ":"odd.organ")").find("odd.organ:2: it has 2 numbers"),
              std::string::npos);
}

} // namespace
} // namespace tractus::lines
