#include "tests/app/verbs/outcome.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>

namespace tractus {
namespace {

namespace fs = std::filesystem;

class SketchCommand : public ::testing::Test {
protected:
    SketchCommand()
    {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        std::ofstream(folder_ / "straight.txt") << "10 20 5\n10 20 105\n";
        std::ofstream(folder_ / "rule.toml")
            << "l = 40\nr = 0.8\nw = 4\nq = 0.5\ns = 0.5\nv = 0.5\n";
    }
    ~SketchCommand() override { fs::remove_all(folder_); }

    std::string path(char const* name) const { return (folder_ / name).string(); }

    fs::path folder_
        = fs::temp_directory_path() / ("tractus_sketch_command." + std::to_string(getpid()));
};

TEST_F(SketchCommand, ReportsWhatAStrokeAmountsTo)
{
    auto const outcome = run({ "sketch", path("straight.txt"), "--rule", path("rule.toml"), "-o",
                               path("out"), "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["segments"], 3);
    EXPECT_EQ(report["depth"], 64);
    EXPECT_EQ(report["nodes"].size(), 4U);
    EXPECT_EQ(report["nodes"][1], (std::vector<double> { 10, 20, 45 }));
    EXPECT_EQ(report["bend"], (std::vector<double> { 0, 0, 0 }));
    ASSERT_EQ(report["counts"].size(), 3U);
    EXPECT_EQ(report["counts"][2]["L"], 14);
    EXPECT_EQ(report["counts"][2]["F"], 11);
}

TEST_F(SketchCommand, WritesAModelThatDerivesToThePlantsString)
{
    ASSERT_EQ(run({ "sketch", path("straight.txt"), "--rule", path("rule.toml"), "-o", path("out"),
                    "--report" })
                  .exit_code,
              0);
    auto const derived = run({ "derive", "--string", "--steps", "1", path("out/straight.l") });
    EXPECT_EQ(derived.err, "");
    EXPECT_EQ(derived.out,
              "/(0)+(0)\\(0)!(4)F(40)[/(90)+(45)L(20,2,64)][/(270)+(45)L(20,2,64)]T(1,32,2)\n");
}

TEST_F(SketchCommand, SaysWhatIsWrongWithAStroke)
{
    std::ofstream(folder_ / "short.txt") << "0 0 0\n0 0 20\n";
    auto const outcome = run({ "sketch", path("short.txt"), "-o", path("out") });
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("the stroke never gets 30 mm away from where it begins"),
              std::string::npos)
        << outcome.err;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    auto const missing
        = run({ "sketch", path("straight.txt"), "--stroke", "2", "-o", path("out") });
    EXPECT_NE(missing.err.find("it has no stroke 2, its last is 1"), std::string::npos)
        << missing.err;
}

} // namespace
} // namespace tractus
