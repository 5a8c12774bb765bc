#include "tests/app/command_line/workshop.h"

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

namespace tractus {
namespace {

// The highest of a .glb file's vertices, in metres: accessors say how far positions reach.
double height_m(std::string const& glb)
{
    std::uint32_t json_bytes = 0;
    std::memcpy(&json_bytes, &glb.at(12), 4);
    double height = 0;
    auto const json = nlohmann::json::parse(glb.substr(20, json_bytes));
    for (auto const& accessor : json["accessors"])
        if (accessor.contains("max"))
            height = std::max(height, accessor["max"][1].get<double>());
    return height;
}

class Animation : public Workshop { };

TEST_F(Animation, ShowsThePlantAsItGrowsToItsFullSize)
{
    auto const outcome = run("tractus grow small.l --animation 12 -o film/small.glb");
    EXPECT_EQ(outcome.exit_code, 1); // There is no such folder.
    ASSERT_EQ(run("mkdir film; tractus grow small.l --animation 12 -o film/small.glb").exit_code,
              0);
    EXPECT_EQ(count_files("film"), 12u);
    ASSERT_EQ(run("tractus grow small.l -o small.glb").exit_code, 0);
    double before = 0;
    for (int i = 1; i <= 12; ++i) {
        auto const number = std::to_string(i);
        double const height
            = height_m(read("film/small-" + std::string(2 - number.size(), '0') + number + ".glb"));
        EXPECT_GE(height, before) << i;
        if (i == 1) {
            EXPECT_LT(height, 0.3 * height_m(read("small.glb")));
        }
        before = height;
    }
    EXPECT_NEAR(before, height_m(read("small.glb")), 1e-5);
}

TEST_F(Animation, IsTheSameAgainOnOneThread)
{
    for (std::string const ending : { "glb", "png", "obj" }) {
        run("tractus grow small.l --animation 2 -o a." + ending);
        run("taskset -c 0 '" TRACTUS_PROGRAM "' grow small.l --animation 2 -o b." + ending);
        for (char const* const frame : { "-1.", "-2." }) {
            EXPECT_FALSE(read("a" + (frame + ending)).empty());
            EXPECT_EQ(read("a" + (frame + ending)), read("b" + (frame + ending)));
        }
    }
}

TEST_F(Animation, OfAPlantWithoutBranchesIsRefused)
{
    write("bare.l", "Lsystem: 1\nderivation length: 1\nAxiom: A\nA --> A\nendlsystem\n");
    expect_error(run("tractus grow bare.l --animation 3 -o x.glb"), 1, "no branch that could grow");
    EXPECT_EQ(run("tractus grow small.l --animation 0 -o x.glb").exit_code, 2);
}

} // namespace
} // namespace tractus
