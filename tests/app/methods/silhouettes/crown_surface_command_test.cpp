#include "app/batch/plant_file.h"
#include "app/batch/session_plant.h"
#include "app/methods/all_methods.h"
#include "app/methods/silhouettes/silhouette_file.h"
#include "tests/app/commands/outcome.h"
#include "tests/file_bytes.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>

namespace tractus::silhouette {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kTurn = 2 * 3.14159265358979;

// Tests of crowns in space whose lines are given in files.
class CrownSurfaceCommand : public ::testing::Test {
protected:
    CrownSurfaceCommand()
    {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~CrownSurfaceCommand() override { fs::remove_all(folder_); }

    std::string write(std::string const& name, json const& drawing) const
    {
        std::ofstream(folder_ / name) << drawing;
        return (folder_ / name).string();
    }

    std::string path(std::string const& name) const { return (folder_ / name).string(); }

    static json ellipse(double wide, double deep, double up = 0)
    {
        json line;
        for (int i = 0; i < 120; ++i)
            line.push_back(
                { wide * std::cos(kTurn * i / 120), up + deep * std::sin(kTurn * i / 120) });
        return line;
    }

    // Returns a drawing with a trunk and elliptic rings whose width is twice their depth.
    static json rings()
    {
        json drawing { { "trunk", { { 0, 0 }, { 0, 100 } } } };
        for (double const height : { 40, 60, 80, 100 })
            drawing["rings"].push_back({ { "height", height }, { "ring", ellipse(40, 20) } });
        return drawing;
    }

    json reported(json const& drawing, std::vector<std::string> const& more = {}) const
    {
        std::vector<std::string> arguments { "silhouette", write("tree.json", drawing),
                                             "--report" };
        arguments.insert(arguments.end(), more.begin(), more.end());
        auto const outcome = commands::run(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return json::parse(outcome.out);
    }

    // Returns the crown's radii about halfway up, in steps of 30 degrees.
    static std::array<double, 12> halfway(json const& report)
    {
        std::array<double, 12> distances {};
        auto const& row = report["surface"]["radius"][5]["at"];
        for (std::size_t i = 0; i < distances.size(); ++i)
            distances.at(i) = row[i].get<double>();
        return distances;
    }

    std::string refusal(json const& drawing) const
    {
        auto const outcome
            = commands::run({ "silhouette", write("bad.json", drawing), "--report" });
        EXPECT_NE(outcome.exit_code, 0);
        return outcome.err;
    }

    fs::path folder_
        = fs::temp_directory_path() / ("tractus_crown_surface_command." + std::to_string(getpid()));
};

TEST_F(CrownSurfaceCommand, ReportsTheSurfaceOfRings)
{
    auto const report = reported(rings());
    EXPECT_EQ(report["surface"]["rings"], 4);
    EXPECT_EQ(report["surface"]["climbs"], 0);
    auto const at = halfway(report);
    for (std::size_t i = 0; i < at.size(); ++i) {
        double const theta = kTurn * static_cast<double>(i) / 12;
        EXPECT_NEAR(at.at(i), 800 / std::hypot(20 * std::cos(theta), 40 * std::sin(theta)), 0.3);
    }
    EXPECT_GE(report["coverage"]["after"], 0.85);
    EXPECT_FALSE(
        reported({ { "outline", ellipse(40, 50) }, { "trunk", { { 0, -60 }, { 0, 30 } } } })
            .contains("surface"));
}

TEST_F(CrownSurfaceCommand, TakesOutlinesFromSeveralSides)
{
    json drawing { { "trunk", { { 7, -60 }, { 7, 30 } } } };
    json front = ellipse(40, 50);
    json side = ellipse(20, 50);
    for (auto* const outline : { &front, &side })
        for (auto& point : *outline)
            point[0] = point[0].get<double>() + 7;
    drawing["outline"] = front;
    drawing["sides"].push_back({ { "azimuth", 90 }, { "outline", side } });
    auto const report = reported(drawing);
    EXPECT_EQ(report["surface"]["sides"], 1);
    auto const at = halfway(report);
    EXPECT_NEAR(at[0], 40, 0.8);
    EXPECT_NEAR(at[3], 20, 0.4);
    EXPECT_NEAR(at[6], 40, 0.8);
    EXPECT_NEAR(at[1], 800 / std::hypot(20 * std::cos(kTurn / 12), 40 * std::sin(kTurn / 12)), 1);
}

TEST_F(CrownSurfaceCommand, TakesALineThatClimbs)
{
    json climb;
    for (int i = 0; i <= 400; ++i) {
        double const r = 40 * (1 - i / 420.0);
        climb.push_back(
            { r * std::cos(kTurn * i / 80), 30 + 0.22 * i, r * std::sin(kTurn * i / 80) });
    }
    auto const report = reported({ { "climbs", json::array({ climb }) } });
    EXPECT_EQ(report["surface"]["climbs"], 1);
    auto const& row = report["surface"]["radius"][5];
    // The trunk's base is below the lower end of the line, by a quarter of the line's height.
    double const up = row["height"].get<double>() - 22;
    for (auto const& distance : row["at"])
        EXPECT_NEAR(distance.get<double>(), 40 * (1 - up / 0.22 / 420), 0.5);
}

// The tree in the session must be the command's, as if a pen had drawn the lines of the file.
TEST_F(CrownSurfaceCommand, WritesASessionOfItsLines)
{
    auto drawing = rings();
    drawing["branches"] = json::array({ { { 0, 60 }, { 15, 66 }, { 30, 70 } } });
    for (std::string const name : { "with_trunk", "without" }) {
        if (name == "without") {
            drawing.erase("trunk");
            drawing.erase("branches");
        }
        auto const file = write(name + ".json", drawing);
        auto const outcome = commands::run(
            { "silhouette", file, "-o", path("out"), "--session", "--levels", "1" });
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        auto const scene = batch::load_session_scene(path("out/" + name + ".tractus"),
                                                     methods::all_methods().edits)
                               .value();
        ASSERT_TRUE(batch::write_plant_file(*scene.base, name, path("again.glb")));
        EXPECT_TRUE(file_bytes(path("out/" + name + ".glb")) == file_bytes(path("again.glb")));
    }
}

TEST_F(CrownSurfaceCommand, SaysWhatIsWrong)
{
    auto beside = rings();
    beside["rings"][1]["ring"] = json::array();
    EXPECT_NE(refusal(beside).find("a dot says nothing of a crown"), std::string::npos);
    auto away = rings();
    for (auto& point : away["rings"][1]["ring"])
        point[0] = point[0].get<double>() + 90;
    EXPECT_NE(refusal(away).find("the ring at 60 mm does not go around the trunk"),
              std::string::npos);
    EXPECT_NE(refusal({ { "rings", { { { "ring", { { 0, 1 } } } } } } })
                  .find("entry 1 of rings is none: write {\"height\": 20, \"ring\": [[x, y], …]}"),
              std::string::npos);
    EXPECT_NE(refusal({ { "climbs", { { { 1, 2 } } } } }).find("is no point in space"),
              std::string::npos);
    EXPECT_NE(refusal({ { "climbs", { { 1, 2 } } } }).find("is no point in space"),
              std::string::npos);
}

} // namespace
} // namespace tractus::silhouette
