#include "sim/gesture_script.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tuple>

namespace tractus::sim {
namespace {

constexpr std::string_view kScript = R"(version = 1
seed = 7

[[gesture]]
tool = "select"
trace = "axis"
axis = 2
height_mm = 80

[[gesture]]
tool = "draw"
propagation = "both"
path = "helix"
foot_mm = [0, 0, 40]
radius_mm = 35
turns = 2
rise_mm = 250
speed_mm_s = 180

[[gesture]]
tool = "indicate"
path = "line"
from_mm = [0, 0, 100]
to_mm = [80.5, 0, 100]
)";

// Returns kScript with the first occurrence of `from` replaced.
std::string with(std::string_view from, std::string_view to)
{
    std::string text(kScript);
    auto const place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
}

std::string error_of(std::string const& text)
{
    auto const script = parse_gesture_script(text, "demo.toml");
    if (script)
        return "no error";
    EXPECT_EQ(script.error().fault, Fault::User);
    return script.error().message;
}

// Returns a script with one gesture. `lines` are the script's lines from line 4 on.
GestureScript one_path(std::string const& lines)
{
    auto const script = parse_gesture_script(
        "version = 1\n[[gesture]]\ntool = \"indicate\"\n" + lines, "demo.toml");
    EXPECT_TRUE(script) << script.error().message;
    return script.value_or(GestureScript {});
}

template<typename Shape> Shape shape_of(std::string const& lines)
{
    return std::get<Shape>(std::get<PathShape>(one_path(lines).gestures.at(0).path));
}

Result<std::vector<Vec2>> no_axes(std::size_t rank)
{
    return fail(Fault::User, "there is no axis " + std::to_string(rank));
}

TEST(GestureScript, ReadsToolsAndPaths)
{
    auto const script = parse_gesture_script(kScript, "demo.toml").value();
    EXPECT_EQ(script.seed, 7u);
    ASSERT_EQ(script.gestures.size(), 3u);
    auto const& [select, draw, indicate]
        = std::tie(script.gestures[0], script.gestures[1], script.gestures[2]);

    EXPECT_EQ(select.tool, "select");
    EXPECT_EQ(std::get<AxisTrace>(select.path).rank, 2u);
    EXPECT_EQ(std::get<AxisTrace>(select.path).height_mm, 80);
    EXPECT_EQ(select.words, "");

    EXPECT_EQ(draw.tool, "draw");
    EXPECT_EQ(draw.words, "both");
    EXPECT_EQ(draw.speed_mm_s, 180);
    auto const& helix = std::get<HelixShape>(std::get<PathShape>(draw.path));
    EXPECT_EQ(helix.foot_mm, Vec3(0, 0, 40));
    EXPECT_EQ(helix.end_radius_mm, 35);
    EXPECT_EQ(helix.rise_mm, 250);

    EXPECT_EQ(indicate.tool, "indicate");
    EXPECT_EQ(indicate.speed_mm_s, 150);
    EXPECT_EQ(std::get<LineShape>(std::get<PathShape>(indicate.path)).to_mm, Vec3(80.5, 0, 100));
}

TEST(GestureScript, ReadsAnArc)
{
    auto const arc = shape_of<HelixShape>("path = \"arc\"\ncenter_mm = [1, 2, 3]\nradius_mm = 40\n"
                                          "start_deg = 90\nsweep_deg = -180\nrise_mm = 5\n");
    EXPECT_EQ(arc.foot_mm, Vec3(1, 2, 3));
    EXPECT_EQ(arc.end_radius_mm, 40);
    EXPECT_DOUBLE_EQ(arc.start_rad, kPi / 2);
    EXPECT_EQ(arc.turns, -0.5);
    EXPECT_EQ(arc.rise_mm, 5);
}

TEST(GestureScript, ReadsAnSCurve)
{
    auto const curve = shape_of<SCurveShape>(
        "path = \"s_curve\"\nfrom_mm = [0, 0, 9]\nto_mm = [0, 50, 9]\nswing_mm = -8\n");
    EXPECT_EQ(curve.to_mm, Vec3(0, 50, 9));
    EXPECT_EQ(curve.swing_mm, -8);
}

TEST(GestureScript, ReadsABranch)
{
    auto const branch = shape_of<BranchShape>(
        "path = \"branch\"\nfrom_mm = [0, 0, 9]\nlength_mm = 120\n"
        "heading_deg = 180\nelevation_deg = 60\nturn_deg = 20\nbend_deg = -30\n");
    EXPECT_EQ(branch.length_mm, 120);
    EXPECT_DOUBLE_EQ(branch.heading_rad, kPi);
    EXPECT_DOUBLE_EQ(branch.elevation_rad, kPi / 3);
    EXPECT_DOUBLE_EQ(branch.turn_rad, kPi / 9);
    EXPECT_DOUBLE_EQ(branch.bend_rad, -kPi / 6);
}

TEST(GestureScript, ReadsAPolyline)
{
    auto const polyline = shape_of<PolylineShape>(
        "path = \"polyline\"\npoints_mm = [[0, 0, 9], [5, 0, 9], [5, 7, 9.5]]\n");
    ASSERT_EQ(polyline.points_mm.size(), 3u);
    EXPECT_EQ(polyline.points_mm[2], Vec3(5, 7, 9.5));
}

TEST(GestureScript, ReadsAnyToolWithItsWords)
{
    auto const script
        = parse_gesture_script("version = 1\n[[gesture]]\ntool = \"hide_plant\"\nwords = \"now\"\n"
                               "[[gesture]]\ntool = \"sketch\"\nwords = \"laterals=3 branch\"\n"
                               "path = \"line\"\nfrom_mm = [0, 0, 9]\nto_mm = [0, 9, 99]\n",
                               "demo.toml")
              .value();
    ASSERT_EQ(script.gestures.size(), 2u);
    EXPECT_TRUE(std::holds_alternative<AtOnce>(script.gestures[0].path));
    EXPECT_EQ(script.gestures[1].tool, "sketch");
    EXPECT_EQ(script.gestures[1].words, "laterals=3 branch");
    EXPECT_EQ(strokes_of(script, {}, no_axes).value().size(), 1u) << "one of them draws nothing";
}

TEST(GestureScript, ErrorsNameFileLineAndKey)
{
    EXPECT_EQ(error_of(with("radius_mm = 35", "radius_mm = -35")),
              "demo.toml:15: gesture[2].radius_mm is -35, expected a number of 0 or more");
    EXPECT_EQ(error_of(with("turns = 2\n", "")),
              "demo.toml:10: gesture[2].turns is missing, expected a number");
    EXPECT_EQ(error_of(with("[80.5, 0, 100]", "[80.5, 0]")),
              "demo.toml:24: gesture[3].to_mm is [80.5, 0], expected an array of 3 numbers, each a "
              "number");
    EXPECT_EQ(error_of(with("\"both\"", "\"all\"")),
              "demo.toml:12: gesture[2].propagation is 'all', expected one of \"selected\", "
              "\"descendants\", \"both\"");
    EXPECT_EQ(
        error_of(with("\"helix\"", "\"helixx\"")),
        "demo.toml:13: gesture[2].path is 'helixx', expected one of \"line\", \"arc\", \"helix\", "
        "\"s_curve\", \"branch\", \"polyline\"");
    EXPECT_EQ(error_of(with("axis = 2", "axis = -2")),
              "demo.toml:7: gesture[1].axis is -2, expected a whole number of 0 or more");
    EXPECT_EQ(error_of(with("speed_mm_s = 180", "speed_mm_s = 0")),
              "demo.toml:18: gesture[2].speed_mm_s is 0, expected 5 to 1000");
    EXPECT_EQ(error_of(with("[80.5, 0, 100]", "[0, 0, 100]")),
              "demo.toml:22: gesture[3].path cannot be drawn, expected one from 0 to 10 m long");
    EXPECT_EQ(error_of(with("version = 1", "version = 2")),
              "demo.toml:1: version is 2, expected at most 1: a later tractus wrote this file, so "
              "use that one to read it");
}

TEST(GestureScript, ReadsHowThePenIsHeld)
{
    auto const script = parse_gesture_script(
        with(
            "version = 1\n",
            "version = 1\ncoil_height_mm = 9\nlean_deg = [40, -20]\nleaned_around_deg = [10, 5]\n"),
        "demo.toml");
    ASSERT_TRUE(script) << script.error().message;
    EXPECT_EQ(script->coil_height_mm, 9);
    EXPECT_EQ(script->lean_deg, Vec2(40, -20));
    EXPECT_EQ(script->leaned_around_deg, Vec2(10, 5));
    EXPECT_FALSE(parse_gesture_script(kScript, "demo.toml").value().lean_deg);
    EXPECT_EQ(error_of(with("version = 1\n", "version = 1\nlean_deg = [90, 0]\n")),
              "demo.toml:2: lean_deg leans the pen by 90 degrees, expected at most 85");
}

TEST(GestureScript, RefusesKeysThatMeanNothing)
{
    EXPECT_EQ(
        error_of(fmt::format("{}propagation = \"both\"\n", kScript)),
        "demo.toml:25: gesture[3].propagation is not a key of this place, expected from_mm, path, "
        "speed_mm_s, to_mm, tool, trace, words");
    EXPECT_EQ(error_of(with("tool = \"select\"", "tool = \"indicate\"")),
              "demo.toml:6: gesture[1].trace is for the tool \"select\", expected a path for "
              "\"indicate\"");
}

TEST(GestureScript, RefusesAScriptWithoutGestures)
{
    EXPECT_EQ(error_of("version = 1\n"),
              "demo.toml:1: gesture is missing, expected tables [[gesture]]");
    EXPECT_EQ(error_of("version = 1\ngesture = []\n"),
              "demo.toml:2: gesture is [], expected tables [[gesture]]");
}

TEST(GestureScript, RefusesAPolylineOfSomethingElse)
{
    std::string const start
        = "version = 1\n[[gesture]]\ntool = \"indicate\"\npath = \"polyline\"\n";
    EXPECT_EQ(
        error_of(start + "points_mm = [[1, 2, 3], [4, 5]]\n"),
        "demo.toml:5: gesture[1].points_mm has [4, 5] as point 2, expected an array of points, "
        "each an array of 3 numbers");
    EXPECT_EQ(
        error_of(start + "points_mm = 3\n"),
        "demo.toml:5: gesture[1].points_mm is 3, expected an array of points, each an array of "
        "3 numbers");
    EXPECT_EQ(error_of(start + "points_mm = [[1, 2, 3]]\n"),
              "demo.toml:4: gesture[1].path cannot be drawn, expected one from 0 to 10 m long");
}

TEST(GestureScript, GivesAStrokePerGestureWithAxesFromTheTracer)
{
    auto const script = parse_gesture_script(kScript, "demo.toml").value();
    RigGeometry const geometry { .tablet_size_mm = { 254, 159 } };
    auto const strokes
        = strokes_of(script, geometry, [](std::size_t rank) -> Result<std::vector<Vec2>> {
              EXPECT_EQ(rank, 2u);
              return std::vector<Vec2> { { 127, 20 }, { 127, 79.5 }, { 147, 100 } };
          }).value();
    ASSERT_EQ(strokes.size(), 3u);
    auto const& traced = strokes[0].path.points_mm();
    ASSERT_EQ(traced.size(), 3u);
    EXPECT_LT((traced[0] - Vec3(0, -59.5, 80)).norm(), 1e-9);
    EXPECT_LT((traced[1] - Vec3(0, 0, 80)).norm(), 1e-9);
    EXPECT_EQ(strokes[1].speed_mm_s, 180);
    EXPECT_NEAR(strokes[2].path.length_mm(), 80.5, 1e-9);
}

TEST(GestureScript, TellsWhichGestureHasNoAxis)
{
    auto const script = parse_gesture_script(kScript, "demo.toml").value();
    auto const strokes = strokes_of(script, {}, no_axes);
    ASSERT_FALSE(strokes);
    EXPECT_EQ(strokes.error().message, "demo.toml:4: gesture[1]: there is no axis 2");
}

TEST(GestureScript, TellsWhichAxisHasNoLength)
{
    auto const script = parse_gesture_script(kScript, "demo.toml").value();
    auto const strokes = strokes_of(script, {}, [](std::size_t) {
        return std::vector<Vec2> { { 9, 9 } };
    });
    ASSERT_FALSE(strokes);
    EXPECT_EQ(strokes.error().message,
              "demo.toml:4: gesture[1]: axis 2 has no length on the tablet, so "
              "it cannot be traced: choose another");
}

TEST(GestureScript, TellsWhichGestureIsOutOfReach)
{
    auto const strokes = strokes_of(
        one_path("path = \"line\"\nfrom_mm = [0, 0, 50]\nto_mm = [0, 0, 450]\n"), {}, no_axes);
    ASSERT_FALSE(strokes);
    EXPECT_EQ(strokes.error().fault, Fault::User);
    EXPECT_EQ(strokes.error().message.substr(0, 62),
              "demo.toml:2: gesture[1]: the place (0.0, 0.0, 450.0) mm is out");
}

constexpr std::string_view kUnkind = R"(
[unkind]
hooks_mm = [0.5, 2]
dab_share = 0.35
tremor_mm = 0.3
reports = "changes"
lost_share = 0.2
batch_ms = 15
wrong_every_ms = 300
stall_every_ms = 700
stall_ms = 80
)";

TEST(GestureScript, ReadsEveryUnkindness)
{
    auto const kind = parse_gesture_script(kScript, "demo.toml").value();
    EXPECT_EQ(kind.unkindness, Unkindness {});
    auto const all = parse_gesture_script(fmt::format("{}{}", kScript, kUnkind), "demo.toml");
    ASSERT_TRUE(all) << all.error().message;
    EXPECT_EQ(all->unkindness, all_unkindness(7));
    RigGeometry const geometry;
    auto const no_tracer = [](std::size_t) { return std::vector<Vec2> { { 50, 50 }, { 90, 90 } }; };
    auto const meant = strokes_of(kind, geometry, no_tracer).value();
    std::size_t count = 0;
    for (auto const& stroke : strokes_of(*all, geometry, no_tracer).value()) {
        if (stroke.is_dab)
            continue;
        ASSERT_LT(count, meant.size());
        EXPECT_GT(stroke.path.length_mm(), meant[count++].path.length_mm()) << "a hook";
    }
    EXPECT_EQ(count, meant.size());
}

TEST(GestureScript, NamesTheUnkindKeyThatIsWrong)
{
    auto const error = [](std::string const& key) {
        return error_of(fmt::format("{}\n[unkind]\n{}\n", kScript, key));
    };
    EXPECT_NE(error("dab_share = 1.5").find("unkind.dab_share is 1.5, expected 0 to 1"),
              std::string::npos)
        << error("dab_share = 1.5");
    EXPECT_NE(error("hooks_mm = [2, 1]").find("unkind.hooks_mm"), std::string::npos);
    EXPECT_NE(error("reports = \"some\"").find("unkind.reports"), std::string::npos);
    EXPECT_NE(error("stall_ms = 80").find("stall_every_ms"), std::string::npos);
    EXPECT_NE(error("stalls = 80").find("unkind.stalls"), std::string::npos);
    EXPECT_NE(error("wrong_in_a_row = 0").find("unkind.wrong_in_a_row"), std::string::npos);
}

} // namespace
} // namespace tractus::sim
