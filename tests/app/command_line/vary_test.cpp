#include "tests/app/command_line/workshop.h"

#include <nlohmann/json.hpp>

namespace tractus {
namespace {

class Vary : public Workshop {
protected:
    void vary(std::string const& arguments, std::string const& before = "") const
    {
        auto const outcome = run(before + " '" TRACTUS_PROGRAM "' vary " + arguments);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }

    // Of a manifest.
    nlohmann::json plants(std::string const& name) const
    {
        return nlohmann::json::parse(read(name), nullptr, false)["plants"];
    }
};

TEST_F(Vary, PartsAreExactlyPartsOfTheWhole)
{
    record();
    std::string const what = "small.l --drawing hand.tractus-log --count 5 --spread scatter";
    vary(what + " -o whole");
    vary(what + " --shard 2/2 -o parts", "taskset -c 0");
    vary(what + " --shard 1/2 -o parts");
    EXPECT_EQ(count_files("whole"), 6u);
    EXPECT_EQ(count_files("parts"), 7u);
    auto const whole = plants("whole/manifest.json");
    auto parts = plants("parts/manifest-1-of-2.json");
    for (auto const& plant : plants("parts/manifest-2-of-2.json"))
        parts.push_back(plant);
    EXPECT_EQ(parts, whole);
    ASSERT_EQ(whole.size(), 5u);
    for (auto const& plant : whole) {
        std::string const file = plant["file"];
        EXPECT_EQ(read("parts/" + file), read("whole/" + file)) << file;
    }
    EXPECT_NE(read("whole/small-1.glb").size(), 0u);
}

TEST_F(Vary, NoTwoPlantsAreAlikeUnlessTheyAreAsDrawn)
{
    record();
    std::string const what = "small.l --drawing hand.tractus-log --count 4 -o ";
    auto const wild = run("tractus vary " + what + "wild --growth wild").out;
    EXPECT_EQ(wild.find(": 0.0 mm"), std::string::npos) << wild;
    auto const drawn = run("tractus vary " + what + "drawn --liking 0").out;
    EXPECT_NE(drawn.find("from plant to plant: 0.0 mm, +- 0.0 mm"), std::string::npos) << drawn;
    EXPECT_NE(drawn.find("from what was drawn: 0.0 mm, +- 0.0 mm"), std::string::npos) << drawn;
}

TEST_F(Vary, OneFileHoldsAllPlants)
{
    vary("small.l --count 6 --seed 9 -o field.glb");
    auto const first = read("field.glb");
    EXPECT_EQ(first.substr(0, 4), "glTF");
    for (char const* const name : { "\"small 1\"", "\"small 6\"" })
        EXPECT_NE(first.find(name), std::string::npos) << name;
    EXPECT_EQ(plants("field.json").size(), 6u);
    vary("small.l --count 6 --seed 9 -o again.glb", "taskset -c 0");
    EXPECT_EQ(read("again.glb"), first);
    vary("small.l --count 6 --seed 10 -o other.glb");
    EXPECT_NE(read("other.glb"), first);
    vary("small.l --count 6 --seed 9 --quantized -o quantized.glb");
    EXPECT_LT(read("quantized.glb").size(), first.size());
    vary("small.l --count 6 --seed 9 --sides 3 -o thin.glb");
    EXPECT_LT(read("thin.glb").size(), first.size());
}

TEST_F(Vary, PlantsAreAsOldAsTheManifestSays)
{
    vary("small.l --count 8 --ages 0.2..0.6 -o young");
    for (auto const& plant : plants("young/manifest.json")) {
        EXPECT_GE(plant["age"], 0.2);
        EXPECT_LT(plant["age"], 0.6);
    }
    vary("small.l --count 8 -o old");
    EXPECT_LT(read("young/small-1.glb").size(), read("old/small-1.glb").size());
}

TEST_F(Vary, WrongUsageIsRefused)
{
    for (auto const& [arguments, reason] :
         { std::pair("small.l --count 0 -o x", "'0' is not a whole number from 1"),
           std::pair("small.l --shard 3/2 -o x", "'3/2' is not a part of at most"),
           std::pair("small.l --shard two -o x", "such as 2/8"),
           std::pair("small.l --ages 0.9..0.2 -o x", "'0.9..0.2' is not a range within 0.01..1"),
           std::pair("small.l --ages old -o x", "'old' is not a range"),
           std::pair("small.l --spread heap -o x", "heap"), std::pair("small.l", "--output"),
           std::pair("small.l --rig a.rig.toml -o x", "--drawing") }) {
        auto const outcome = run(std::string("tractus vary ") + arguments);
        EXPECT_EQ(outcome.exit_code, 2) << arguments;
        EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
    }
    EXPECT_FALSE(exists("x"));
}

TEST_F(Vary, AFullDiskLeavesWhatWasWrittenBefore)
{
    vary("small.l --count 3 -o out");
    auto const first = read("out/small-1.glb");
    // Longer branches cut into more pieces: too much for the limit.
    auto const outcome = run(
        "ulimit -f 2; tractus vary small.l --growth wild --seed 2 --sides 64 --count 3 -o out");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("0 of 3 plants are written"), std::string::npos) << outcome.err;
    EXPECT_EQ(read("out/small-1.glb"), first);
    EXPECT_EQ(count_files("out"), 4u);
}

} // namespace
} // namespace tractus
