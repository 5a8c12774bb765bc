#include "tests/app/command_line/workshop.h"

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

namespace tractus {
namespace {

nlohmann::json json_of(std::string const& glb)
{
    std::uint32_t json_bytes = 0;
    std::memcpy(&json_bytes, &glb.at(12), 4);
    return nlohmann::json::parse(glb.substr(20, json_bytes));
}

// Returns the maximum height of the vertices in a .glb file, in metres, as stated by the bounds of
// its accessors.
double height_m(std::string const& glb)
{
    double height = 0;
    auto const json = json_of(glb);
    for (auto const& accessor : json["accessors"])
        if (accessor.contains("max"))
            height = std::max(height, accessor["max"][1].get<double>());
    return height;
}

class Animation : public Workshop { };

TEST_F(Animation, ShowsThePlantAsItGrowsToItsFullSize)
{
    ASSERT_EQ(run("tractus grow small.l --sequence 12 -o film/small.glb").exit_code, 0);
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

TEST_F(Animation, OneAgeOfItIsWrittenAlone)
{
    run("mkdir film");
    ASSERT_EQ(run("tractus grow small.l --sequence 2 -o film/small.glb").exit_code, 0);
    ASSERT_EQ(run("tractus grow small.l --age 0.5 -o film/young.glb").exit_code, 0);
    EXPECT_FLOAT_EQ(height_m(read("film/young.glb")), height_m(read("film/small-1.glb")));
    EXPECT_LT(height_m(read("film/young.glb")), height_m(read("film/small-2.glb")));
    EXPECT_EQ(run("tractus grow small.l --age 0.5 --sequence 2 -o film/small.glb").exit_code, 2);
}

TEST_F(Animation, IsTheSameAgainOnOneThread)
{
    for (std::string const ending : { "glb", "png", "obj" }) {
        run("mkdir -p all one");
        run("tractus grow small.l --sequence 2 -o all/tree." + ending);
        run("taskset -c 0 '" TRACTUS_PROGRAM "' grow small.l --sequence 2 -o one/tree." + ending);
        for (char const* const frame : { "-1.", "-2." }) {
            auto const file = "/tree" + (frame + ending);
            EXPECT_FALSE(read("all" + file).empty());
            EXPECT_TRUE(read("all" + file) == read("one" + file)) << file;
        }
    }
}

TEST_F(Animation, IsOneFileWithATargetForEachAge)
{
    auto const outcome = run("tractus grow small.l --animation 6 --seconds 3 -o film.glb");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("6 ages in 3 s"), std::string::npos) << outcome.out;
    auto const json = json_of(read("film.glb"));
    auto const& mesh = json["meshes"][0];
    EXPECT_EQ(mesh["weights"].size(), 5u);
    EXPECT_EQ(mesh["primitives"][0]["targets"].size(), 5u);
    EXPECT_EQ(json["animations"][0]["channels"][0]["target"]["path"], "weights");
    auto const& times = json["animations"][0]["samplers"][0]["input"];
    EXPECT_EQ(json["accessors"][times.get<std::size_t>()]["max"][0], 3);
    run("taskset -c 0 '" TRACTUS_PROGRAM "' grow small.l --animation 6 --seconds 3 -o again.glb");
    EXPECT_EQ(read("again.glb"), read("film.glb"));
    expect_error(run("tractus grow small.l --animation 6 -o film.png"), 1, "--sequence");
    EXPECT_EQ(run("tractus grow small.l --animation 6 --sequence 6 -o x.glb").exit_code, 2);
    EXPECT_EQ(run("tractus grow small.l --seconds 3 -o x.glb").exit_code, 2);
    expect_error(run("tractus grow small.l --animation 6 --organs nodes -o x.glb"), 2, "--organs");
}

TEST_F(Animation, KeepsWhatWasDrawnAndGrowsAsItIsTold)
{
    record();
    std::set<std::string> films;
    for (std::string const how :
         { "", "--drawing hand.tractus-log", "--growth wild", "--growth wild --variability 2",
           "--growth wild --seed 2", "--drawing hand.tractus-log --growth weeping" }) {
        for (std::string const what : { "", "--animation 3 " }) {
            auto const outcome = run("tractus grow small.l -o film.glb " + what + how);
            ASSERT_EQ(outcome.exit_code, 0) << how << outcome.err;
            EXPECT_TRUE(films.insert(read("film.glb")).second) << what << how;
        }
    }
}

TEST_F(Animation, OfASessionIsOfWhatItShows)
{
    record();
    ASSERT_EQ(run("tractus replay hand.tractus-log --plant small.l --session kept.tractus "
                  "--growth weeping -o out")
                  .exit_code,
              0);
    auto const grow = [&](std::string const& how) {
        auto const outcome = run("tractus grow kept.tractus --animation 3 -o film.glb " + how);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return read("film.glb");
    };
    auto const own = grow("");
    EXPECT_EQ(grow("--growth weeping"), own);
    EXPECT_NE(grow("--growth usual"), own); // This preset differs from the session's.
    EXPECT_NE(grow("--seed 7"), own);
}

TEST_F(Animation, OfAPlantWithoutBranchesIsRefused)
{
    write("bare.l", "Lsystem: 1\nderivation length: 1\nAxiom: A\nA --> A\nendlsystem\n");
    expect_error(run("tractus grow bare.l --sequence 3 -o x.glb"), 1, "no branch that could grow");
    expect_error(run("tractus grow bare.l --animation 3 -o x.glb"), 1, "no branch that could grow");
    EXPECT_EQ(run("tractus grow small.l --sequence 0 -o x.glb").exit_code, 2);
    EXPECT_EQ(run("tractus grow small.l --animation 1 -o x.glb").exit_code, 2);
}

} // namespace
} // namespace tractus
